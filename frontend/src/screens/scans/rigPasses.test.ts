import { describe, expect, it } from "vitest";
import { nextPass, tableOf } from "./rigPasses";

describe("passes as they are typed", () => {
  it("carries on what stays, and nothing that was seen", () => {
    const one = { ...nextPass("board"), distance_m: "3", width_m: "0,8", front_line_1: "100" };
    expect(nextPass("board", one)).toMatchObject({ distance_m: "3", width_m: "0,8", front_line_1: "" });
  });

  it("becomes a table without the rows in which nothing was seen", async () => {
    const one = { ...nextPass("positions"), distance_m: "3", position_1_m: "1", position_2_m: "1,6" };
    const file = tableOf("positions", [one, nextPass("positions", one), { ...one, u_position_m: '0.001"' }]);
    expect(await file?.text()).toBe(
      "pass;distance_m;u_distance_m;position_1_m;position_2_m;u_position_m\n1;3;;1;1.6;\n3;3;;1;1.6;0.001",
    );
    expect(tableOf("speed", [nextPass("speed")])).toBeNull();
  });
});
