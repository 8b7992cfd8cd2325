// A post of nine square rings, as any loader gives a mesh.
const positions = [0, 0, 0, 0, 160, 0];
const faces = [];
for (let y = 0; y < 9; y++) {
  for (let k = 0; k < 4; k++) {
    positions.push(k % 2 ? 20 * (k - 2) : 0, 20 * y, k % 2 ? 0 : 20 * (k - 1));
    const [a, b] = [4 * y + k + 2, 4 * y + ((k + 1) % 4) + 2];
    if (y === 0) faces.push(0, b, a);
    faces.push(...(y < 8 ? [a, b, b + 4, a, b + 4, a + 4] : [a, b, 1]));
  }
}

export const mesh = { positions, faces };
