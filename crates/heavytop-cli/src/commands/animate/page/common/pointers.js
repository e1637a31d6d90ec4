// What pointers do on an element: drag, turn and pinch; and the keys of the view.

const byId = (id) => document.getElementById(id);

/** Calls back while the pointer, pressed on the element, moves. */
function drag(element, moved) {
  element.addEventListener("pointerdown", (event) => element.setPointerCapture(event.pointerId));
  element.addEventListener("pointermove", (event) => {
    if (element.hasPointerCapture(event.pointerId)) moved(event);
  });
}

/** Calls back while one pointer drags, and while two of them come closer or part. */
function turnAndPinch(element, turn, enlarge) {
  const pointers = new Map();
  const distance = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y) || 1;
  };
  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  element.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const before = pointers.size === 2 ? distance() : undefined;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (before) enlarge(distance() / before);
    else if (pointers.size === 1) turn(event.clientX - last.x, event.clientY - last.y);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    element.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
}

/** Turns the view of a scene by dragging, and enlarges it by pinching and by the wheel; a double click resets it. */
function viewByPointers({ canvas, camera }, changed) {
  const enlarge = (factor) => {
    camera.enlarge(factor);
    changed();
  };
  const turn = (x, y) => {
    camera.turn(-0.008 * x, 0.008 * y);
    changed();
  };
  turnAndPinch(canvas, turn, enlarge);
  canvas.addEventListener("dblclick", () => {
    camera.reset();
    changed();
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    enlarge(Math.exp(-0.001 * event.deltaY));
  }, { passive: false });
}

/** What the keys of the view do. */
function viewKeys(camera, changed) {
  const view = (change) => () => {
    change();
    changed();
  };
  return {
    a: view(() => camera.turn(0.1, 0)), d: view(() => camera.turn(-0.1, 0)),
    w: view(() => camera.turn(0, 0.1)), s: view(() => camera.turn(0, -0.1)),
    "+": view(() => camera.enlarge(1.1)), "-": view(() => camera.enlarge(1 / 1.1)), "0": view(() => camera.reset()),
  };
}
