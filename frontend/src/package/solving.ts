/** Small systems of equations: a handful of unknowns. */

/** x of A x = b by elimination with the largest pivot; null where A is singular or not finite. */
export function solved(matrix: readonly (readonly number[])[], right: readonly number[]): number[] | null {
  const size = right.length;
  const rows = matrix.map((row, n) => [...row, right[n] as number]);
  for (let column = 0; column < size; column++) if (!eliminated(rows, column)) return null;
  const found = new Array<number>(size).fill(0);
  for (let n = size - 1; n >= 0; n--) {
    const row = rows[n] as number[];
    let rest = row[size] as number;
    for (let k = n + 1; k < size; k++) rest -= (row[k] as number) * (found[k] as number);
    found[n] = rest / (row[n] as number);
  }
  return found.every(Number.isFinite) ? found : null;
}

/** Takes a column out of all rows below; false where nothing can be divided by. */
function eliminated(rows: number[][], column: number): boolean {
  const best = rows.reduce((at, row, n) => (n > at && larger(row, rows[at], column) ? n : at), column);
  const pivot = rows[best] as number[];
  const value = pivot[column] as number;
  if (!(Math.abs(value) > 1e-300) || !Number.isFinite(value)) return false;
  [rows[best], rows[column]] = [rows[column] as number[], pivot];
  for (const row of rows.slice(column + 1)) {
    const share = (row[column] as number) / value;
    for (let k = column; k < row.length; k++) row[k] = (row[k] as number) - share * (pivot[k] as number);
  }
  return true;
}

function larger(row: number[], other: number[] | undefined, column: number): boolean {
  return Math.abs(row[column] ?? 0) > Math.abs(other?.[column] ?? 0);
}

/** Largest over smallest eigenvalue of a symmetric matrix, by Jacobi's rotations. */
export function condition(matrix: readonly (readonly number[])[]): number {
  const a = matrix.map((row) => [...row]);
  const at = (i: number, j: number) => a[i]?.[j] ?? 0;
  for (let sweep = 0; sweep < 30; sweep++) {
    for (let p = 0; p < a.length; p++)
      for (let q = p + 1; q < a.length; q++) if (at(p, q) !== 0) rotate(a, p, q);
  }
  const values = a.map((_, n) => Math.abs(at(n, n)));
  return Math.max(...values) / Math.min(...values);
}

function rotate(a: number[][], p: number, q: number): void {
  const [rowP, rowQ] = [a[p] as number[], a[q] as number[]];
  const angle = 0.5 * Math.atan2(2 * (rowP[q] as number), (rowQ[q] as number) - (rowP[p] as number));
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  for (let k = 0; k < a.length; k++) {
    const [x, y] = [rowP[k] as number, rowQ[k] as number];
    [rowP[k], rowQ[k]] = [c * x - s * y, s * x + c * y];
  }
  for (const row of a) {
    const [x, y] = [row[p] as number, row[q] as number];
    [row[p], row[q]] = [c * x - s * y, s * x + c * y];
  }
}
