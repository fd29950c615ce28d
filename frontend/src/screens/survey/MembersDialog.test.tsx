import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, expect, it, vi } from "vitest";
import { AddMember } from "./MembersDialog";

afterEach(() => render(null, document.body));

const OTHERS = [
  { id: 1, name: "Ada", account_role: "admin" },
  { id: 2, name: "Rosa", account_role: "reviewer" },
] as const;

it("offers the role of the account, and says of an administrator that the role changes nothing", async () => {
  const add = vi.fn(async () => {});
  render(<AddMember others={OTHERS} add={add} />, document.body);
  const [person, role] = [...document.querySelectorAll("select")] as [HTMLSelectElement, HTMLSelectElement];
  const choose = (id: string) =>
    act(() => {
      person.value = id;
      person.dispatchEvent(new Event("change", { bubbles: true }));
    });
  await choose("2");
  expect(role.value).toBe("reviewer");
  await choose("1");
  expect(document.body.textContent).toContain("whatever role is chosen");
  await choose("2");
  document.querySelector("button")?.click();
  expect(add).toHaveBeenCalledWith(2, "reviewer");
});
