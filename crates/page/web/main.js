// What keys, buttons and the address do.

/** What is asked for in the address, such as page.html#top=lagrange&method=rk4&step=0.05&time=20&play=0. */
function asked() {
  return new URLSearchParams(location.hash.slice(1));
}

/** Chooses what the address asks for. */
function obey(request, form) {
  const place = (items, name) => items.findIndex((item) => item.name === name);
  if (place(TOPS, request.get("top")) >= 0) form.fill(place(TOPS, request.get("top")));
  if (place(METHODS, request.get("method")) >= 0) form.choose("method", place(METHODS, request.get("method")));
  if (Number(request.get("step")) > 0) form.chooseStep(Number(request.get("step")));
  if (Number(request.get("friction")) > 0) form.chooseFriction(Number(request.get("friction")));
  if (SPEEDS.includes(Number(request.get("speed")))) byId("speed").value = request.get("speed");
  if (["light", "dark"].includes(request.get("theme"))) theme.choose(request.get("theme"));
}

/** Throws the top from a point of the section that is found by trying. */
function newOrbit(player) {
  const { section } = player;
  if (!section.bound) section.bound = 1;
  for (let attempt = 0; attempt < 1000; attempt++) {
    const [x, y] = [2 * Math.PI * Math.random(), section.bound * (2 * Math.random() - 1)];
    try {
      player.beginOrbit(x, y);
      return;
    } catch {
      // No state is there: try another point.
    }
  }
  section.say("No state of this energy was found on the section.");
}

function listen(player, form) {
  const throwAgain = () => {
    if (player.throwTop()) player.toggle(true);
  };
  const surprise = () => {
    form.surprise();
    throwAgain();
  };
  const click = (id, action) => byId(id).addEventListener("click", action);
  click("play", () => player.toggle());
  click("throw", throwAgain);
  click("surprise", surprise);
  click("anew", () => player.measureAnew());
  click("orbit", () => newOrbit(player));
  click("theme", () => theme.choose(theme.isDark ? "light" : "dark"));
  click("section", ({ offsetX, offsetY }) => {
    const [x, y] = player.section.pointAt(offsetX, offsetY);
    try {
      player.beginOrbit(x, y);
      player.section.say("A new orbit, with the energy and the Π·Γ of the others.");
    } catch {
      player.section.say("No state of this energy and Π·Γ is there. Try another point.");
    }
  });

  const keys = {
    ...viewKeys(player.scene.camera, () => player.redraw()),
    " ": () => player.toggle(), t: throwAgain, r: surprise, n: () => newOrbit(player),
    "[": () => form.moveStep(-1), "]": () => form.moveStep(1),
  };
  keys.v = keys["0"];
  METHODS.forEach((_, index) => {
    keys[String((index + 1) % 10)] = () => {
      form.choose("method", index);
      player.changeMethod(index);
    };
  });
  document.addEventListener("keydown", (event) => {
    const { key, target, ctrlKey, altKey, metaKey } = event;
    // Fields and lists have their own keys; buttons and chips have the space bar.
    const types = target.tagName === "SELECT" || (target.tagName === "INPUT" && target.type === "number");
    const presses = key === " " && ["BUTTON", "SUMMARY", "INPUT"].includes(target.tagName);
    const action = types || presses || ctrlKey || altKey || metaKey ? undefined : keys[key.toLowerCase()];
    if (action) {
      event.preventDefault();
      action();
    }
  });

  viewByPointers(player.scene, () => player.redraw());
  const sizes = new ResizeObserver(() => player.redraw());
  for (const id of ["scene", "chart", "section"]) sizes.observe(byId(id));
  const nameTheme = () => {
    byId("theme").textContent = theme.isDark ? "Light" : "Dark";
    player.section.stale = true;
    player.redraw();
  };
  theme.onChange(nameTheme);
  nameTheme();
}

let player;

async function start() {
  const library = await Library.load(byId("module").textContent);
  const names = library.lines("describe_methods");
  if (METHODS.some(({ name }, i) => name !== names[i])) throw new Error("the methods are not those of the library");
  const form = new Form({
    method: (index) => player.changeMethod(index),
    step: (step) => player.changeStep(step),
    friction: (coefficient) => player.changeFriction(coefficient),
    section: () => player.changeSection(),
    thrown: () => player.throwTop(),
  });
  const request = asked();
  obey(request, form);
  player = new Player(library, form);
  listen(player, form);
  if (!player.throwTop()) return;
  player.catchUp = Math.max(Number(request.get("time")) || 0, 0);
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches || request.get("play") === "0";
  player.toggle(!still || player.catchUp > 0);
  // Somebody who only looks sees what a method changes; whoever does anything ends the opening.
  player.opens = !still && [...request.keys()].length === 0;
  player.pauseAt = still && player.catchUp > 0 ? player.catchUp : undefined;
}

start().catch((error) => {
  byId("trouble").hidden = false;
  byId("trouble").textContent = error.message;
  console.error(error);
});
