/** A drawn figure as a file of its own: the page's variables become the colours of the light look. */

const LIGHT: Record<string, string> = {
  "--ink": "#1a1b18",
  "--ink-2": "#55564f",
  "--ink-3": "#696a62",
  "--line": "#d6d6ce",
  "--line-strong": "#84857c",
  "--surface": "#ffffff",
  "--curve-2": "#7d3f9e",
  "--curve-3": "#a86200",
  "--accent": "#f5b800",
  "--accent-text": "#7a5300",
  "--font": "sans-serif",
};

export function svgFile(drawn: Element, title: string): string {
  const copy = drawn.cloneNode(true) as SVGElement;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.style.setProperty("color", LIGHT["--ink"] as string);
  const words = document.createElementNS("http://www.w3.org/2000/svg", "title");
  words.textContent = title;
  const paper = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  for (const [name, value] of [
    ["width", "100%"],
    ["height", "100%"],
    ["fill", "#ffffff"],
  ] as const)
    paper.setAttribute(name, value);
  copy.prepend(words, paper);
  const text = new XMLSerializer().serializeToString(copy);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${resolved(text)}\n`;
}

/** Text without the page's variables. */
export function resolved(text: string): string {
  return text.replace(/var\((--[\w-]+)\)/g, (_, name: string) => LIGHT[name] ?? "currentColor");
}
