/** README.txt of a package: a title, then parts of a heading, a line below it, and items that begin with "- ". */

export const README = "README.txt";

export interface Part {
  readonly heading: string;
  readonly items: readonly string[];
}

export function partsOf(text: string): Part[] {
  return text
    .split("\n\n")
    .slice(1)
    .map((block) => {
      const [heading = "", , ...lines] = block.trimEnd().split("\n");
      return { heading, items: lines.join("\n").replace(/^- /, "").split("\n- ").map(unwrapped) };
    });
}

const unwrapped = (item: string) => item.replaceAll("\n  ", " ");
