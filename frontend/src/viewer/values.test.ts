import { expect, it } from "vitest";
import { imagePoint } from "./points";
import { madeOf, type Values } from "./values";

const CONTACT = imagePoint(100, 400);
const POINT = imagePoint(101, 250);
const ELSEWHERE = imagePoint(140, 300);
const values = (change: Partial<Values>): Values => ({
  target: "driver_eye",
  frame: 40,
  contact: CONTACT,
  point: POINT,
  more: [],
  inset: null,
  sigma_px: null,
  withdrawn: false,
  ...change,
});
const proposed = { frame: 40, contact: CONTACT, point: POINT };

it.each([
  ["clicked by hand where nothing was proposed", {}, "clicked"],
  ["clicked by hand on another frame than the proposal", { proposed, frame: 41 }, "clicked"],
  ["a proposal confirmed as it stood", { proposed }, "confirmed"],
  ["its target moved", { proposed, point: ELSEWHERE }, "moved"],
  ["its contact moved", { proposed, contact: ELSEWHERE }, "moved"],
  ["both moved", { proposed, contact: ELSEWHERE, point: ELSEWHERE }, "moved"],
] as const)("%s", (_case, change, made) => {
  expect(madeOf(values(change))).toBe(made);
});
