import { afterEach, describe, expect, it, vi } from "vitest";
import { ApiError, api } from "../../core/api";
import { TrafficModel } from "./model";

afterEach(() => vi.restoreAllMocks());

describe("the direction of travel", () => {
  it("comes up when it is tried again after a failure", async () => {
    const get = vi.spyOn(api, "get").mockRejectedValue(new ApiError("The server could not do this.", 500));
    const model = new TrafficModel(5);
    await model.load(null);
    expect(model.problem.value).toBeInstanceOf(ApiError);
    get.mockImplementation(async (path) => (path.endsWith("/traffic") ? { poses: [], pairs: [] } : []));
    await model.load(null);
    expect(model.problem.value).toBeNull();
    expect(model.loaded.value).toBe(true);
    model.close();
  });
});
