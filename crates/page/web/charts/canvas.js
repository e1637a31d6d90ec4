// What the charts share.

const CHART_FONT = "12px system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif";

/** Sets the size of a canvas in pixels of the screen, and returns what paints on it. */
function sized(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const { clientWidth: width, clientHeight: height } = canvas;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  const changed = canvas.width !== w || canvas.height !== h;
  if (changed) [canvas.width, canvas.height] = [w, h];
  const paint = canvas.getContext("2d");
  paint.setTransform(ratio, 0, 0, ratio, 0, 0);
  paint.font = CHART_FONT;
  paint.lineJoin = "round";
  return { paint, width, height, changed };
}

function colorOf(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
