import { useId } from "preact/hooks";
import { chooseLanguage, LANGUAGES, language, say } from "../core/messages";

/** The language spoken in this browser, as a field: `class` says how it is laid out, as a form's or as a menu's. */
export function LanguageChoice({ class: look }: { class: string }) {
  const id = useId();
  if (LANGUAGES.length < 2) return null;
  return (
    <div class={look}>
      <label class="field__label" for={id}>
        {say("menu-language")}
      </label>
      <select
        id={id}
        class="input"
        value={language.value}
        onChange={(event) => void chooseLanguage(event.currentTarget.value)}
      >
        {LANGUAGES.map((name) => (
          <option key={name} value={name} lang={name}>
            {nameOfLanguage(name)}
          </option>
        ))}
      </select>
    </div>
  );
}

export function nameOfLanguage(name: string): string {
  return new Intl.DisplayNames([name], { type: "language" }).of(name) ?? name;
}
