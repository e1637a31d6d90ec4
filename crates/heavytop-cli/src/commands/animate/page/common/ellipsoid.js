// The body as an ellipsoid.

/** The faces of the homogeneous ellipsoid with these moments, its largest semi-axis 0.62. */
function ellipsoid([first, second, third]) {
  const squares = [second + third - first, third + first - second, first + second - third];
  const largest = Math.max(...squares);
  // A plate has some thickness to be seen.
  const axes = squares.map((square) => 0.62 * Math.max(Math.sqrt(Math.max(square, 0) / largest), 0.05));
  const [around, across] = [40, 20];
  const direction = (i, j) => {
    const [a, b] = [2 * Math.PI * i / around, Math.PI * j / across];
    return [Math.sin(b) * Math.cos(a), Math.sin(b) * Math.sin(a), Math.cos(b)];
  };
  const faces = [];
  for (let i = 0; i < around; i++) {
    for (let j = 0; j < across; j++) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const middle = direction(i + 0.5, j + 0.5);
      faces.push({
        corners: corners.map(([k, l]) => direction(k, l).map((x, axis) => axes[axis] * x)),
        normal: unit(middle.map((x, axis) => x / axes[axis])),
        // Octants, so that one sees it turn about each axis.
        tint: middle[0] * middle[1] * middle[2] > 0 ? 1 : 0,
      });
    }
  }
  return faces;
}
