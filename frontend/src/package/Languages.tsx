import { language, speak } from "./language";
import { LANGUAGES } from "./say";

/** The page in another language; a package's conclusion, figures and report stay in its own. */
export function Languages() {
  if (LANGUAGES.length < 2) return null;
  return (
    <div class="opened__languages">
      {LANGUAGES.map((name) => (
        <button
          key={name}
          type="button"
          lang={name}
          aria-pressed={name === language.value}
          onClick={() => speak(name)}
        >
          {new Intl.DisplayNames([name], { type: "language" }).of(name) ?? name}
        </button>
      ))}
    </div>
  );
}
