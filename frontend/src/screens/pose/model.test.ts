import { afterEach, describe, expect, it, vi } from "vitest";
import { ApiError, api } from "../../core/api";
import { PoseModel } from "./model";

afterEach(() => vi.restoreAllMocks());

describe("the road pose page", () => {
  it("comes up when it is tried again after a failure", async () => {
    const get = vi.spyOn(api, "get").mockRejectedValue(new ApiError("The server could not do this.", 500));
    const model = new PoseModel(5);
    await model.load();
    expect(model.problem.value).toBeInstanceOf(ApiError);
    get.mockResolvedValue([]);
    await model.load();
    expect(model.problem.value).toBeNull();
    expect(model.loaded.value).toBe(true);
    model.close();
  });
});
