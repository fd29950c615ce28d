import { render } from "preact";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import { AskDialog } from "../../components";
import { me } from "../../core/session";
import type { Me } from "../../core/types";
import PeopleScreen from "./PeopleScreen";

const viola = { id: 2, name: "Viola", email: "v@x", role: "viewer", active: true, has_password: true };
let server: FakeServer;

beforeEach(async () => {
  server = new FakeServer("admin");
  me.value = { person: { id: 1, name: "Ada", role: "admin" } } as unknown as Me;
  server.on("GET", /^\/people$/, () => [viola]);
  render(
    <>
      <PeopleScreen />
      <AskDialog />
    </>,
    document.body,
  );
  await vi.waitFor(() => expect(document.querySelector("select")).not.toBeNull());
});
afterEach(() => {
  render(null, document.body);
  me.value = undefined;
  vi.unstubAllGlobals();
});

const button = (name: string) =>
  [...document.querySelectorAll("button")].find((one) => one.textContent?.trim() === name);

async function choose(role: string, answer: string): Promise<void> {
  const list = document.querySelector("select") as HTMLSelectElement;
  list.value = role;
  list.dispatchEvent(new Event("change", { bubbles: true }));
  await vi.waitFor(() => expect(document.querySelector("dialog")?.textContent).toContain("Viola"));
  button(answer)?.click();
  await vi.waitFor(() => expect(document.querySelector("dialog")).toBeNull());
}

it("asks before a role becomes another, and changes nothing where it is not confirmed", async () => {
  await choose("admin", "Cancel");
  expect(server.writes).toEqual([]);
  await choose("operator", "Change the role");
  await vi.waitFor(() => expect(server.writes).toEqual(["PUT /people/2"]));
});
