/** A dialog's form is sent by the one button that says what it does, Enter or a press. */
import { render } from "preact";
import { afterEach, expect, it, vi } from "vitest";
import { FormDialog } from "./FormDialog";

afterEach(() => render(null, document.body));

it("has no second button that sends it", () => {
  const submit = vi.fn(async () => undefined);
  render(
    <FormDialog label="Camera" action="Add" onClose={() => {}} submit={submit}>
      <input />
    </FormDialog>,
    document.body,
  );
  const form = document.querySelector("form");
  const sending = [...document.querySelectorAll<HTMLButtonElement>("button[type=submit]")];
  expect(sending.map((one) => one.textContent)).toEqual(["Add"]);
  expect(sending[0]?.getAttribute("form")).toBe(form?.id);
  form?.requestSubmit();
  expect(submit).toHaveBeenCalledOnce();
});
