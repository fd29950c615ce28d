import { describe, expect, it } from "vitest";
import { spanProblem } from "./span";

const span = { first_frame: 10, best_frame: 15, last_frame: 20 };

describe("a pass's frames", () => {
  it("may move while the best one stays inside", () => {
    expect(spanProblem(span, "first_frame", "15")).toBeNull();
    expect(spanProblem(span, "last_frame", "400")).toBeNull();
    expect(spanProblem(span, "best_frame", "20")).toBeNull();
    expect(spanProblem(span, "best_frame", "")).toBeNull();
  });

  it("are refused in words", () => {
    expect(spanProblem(span, "first_frame", "21")).toContain("is after 20");
    expect(spanProblem(span, "last_frame", "14")).toContain("best (15)");
    expect(spanProblem(span, "best_frame", "9")).toContain("10 to 20");
    for (const text of ["", "-1", "1.5", "x"]) expect(spanProblem(span, "last_frame", text)).not.toBeNull();
  });

  it("without a best one only need their order", () => {
    expect(spanProblem({ ...span, best_frame: null }, "last_frame", "10")).toBeNull();
  });
});
