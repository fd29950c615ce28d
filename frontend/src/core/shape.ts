/** Whether what came from outside has the fields that are read of it: types are gone where the pages run. */

type Sort = "number" | "string" | "boolean" | "list" | "object" | "nullable";

/** A test for things with these fields of these sorts. What is not named is not looked at. */
export function shapeOf<T>(fields: Partial<Record<keyof T, Sort>>): (answer: unknown) => answer is T {
  const named = Object.entries(fields) as [string, Sort][];
  return (answer): answer is T =>
    isObject(answer) && named.every(([name, sort]) => isOf(sort, (answer as Record<string, unknown>)[name]));
}

function isOf(sort: Sort, value: unknown): boolean {
  if (sort === "list") return Array.isArray(value);
  if (sort === "object") return isObject(value);
  if (sort === "nullable") return value === null || isObject(value);
  return typeof value === sort;
}

function isObject(value: unknown): value is object {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
