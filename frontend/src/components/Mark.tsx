import { theme } from "../core/theme";

/** The mark: a road, a post, and the line of sight that meets its top. */
export function Mark({ size = 24 }: { size?: number }) {
  const ink = theme.value === "dark" ? "#ecece6" : "#1a1b18";
  return (
    <svg width={size} height={size} viewBox="0 0 24 24" fill="none" aria-hidden="true" stroke-linecap="round">
      <path d="M2 19.5h20" stroke={ink} stroke-width="2" />
      <path d="M16.5 19V11.5" stroke={ink} stroke-width="2" />
      <path d="M2.5 5.5l11.6 4.6" stroke={ink} stroke-width="1.6" stroke-dasharray="0.1 3.2" />
      <circle cx="16.5" cy="9.8" r="3" fill="var(--accent)" stroke={ink} stroke-width="1.6" />
    </svg>
  );
}
