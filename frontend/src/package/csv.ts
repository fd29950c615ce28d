/** RFC 4180, as the tables of a package are written: comma, line feed, quotes where they are needed. */

export type Row = Readonly<Record<string, string>>;

/** The cells of every line, the header's first. Throws for a quote that does not end. */
export function cellsOf(text: string): string[][] {
  const lines: string[][] = [];
  let line: string[] = [];
  let at = 0;
  while (at < text.length) {
    let cell: string;
    if (text[at] === '"') {
      const end = endOfQuoted(text, at + 1);
      cell = text.slice(at + 1, end).replaceAll('""', '"');
      at = end + 1;
    } else {
      const end = endOfPlain(text, at);
      cell = text.slice(at, end);
      at = end;
    }
    line.push(cell);
    if (text[at] === ",") {
      at++;
      if (at === text.length || text[at] === "\n") line.push("");
    }
    if (at >= text.length || text[at] === "\n") {
      lines.push(line);
      line = [];
      at++;
    }
  }
  return lines;
}

function endOfQuoted(text: string, start: number): number {
  let end = text.indexOf('"', start);
  while (text[end + 1] === '"') end = text.indexOf('"', end + 2);
  if (end < 0) throw new Error("a quote does not end");
  return end;
}

function endOfPlain(text: string, start: number): number {
  let end = start;
  while (end < text.length) {
    const code = text.charCodeAt(end);
    if (code === 44 || code === 10) break;
    end++;
  }
  return end;
}

/** The rows of a table by column. Throws for a row that is too long or too short. */
export function rowsOf(text: string): Row[] {
  const [header = [], ...lines] = cellsOf(text);
  return lines.map((cells) => {
    if (cells.length !== header.length) throw new Error("a row is too long or too short");
    const row: Record<string, string> = {};
    for (let n = 0; n < header.length; n++) row[header[n] as string] = cells[n] as string;
    return row;
  });
}

const FORMULA = /^[ \t\r\n\0\ufeff\xa0]*[=+\-@＝＋－＠]|^[\t\r\n]/;

/** A cell's text without the apostrophe that keeps a spreadsheet from running it. */
export function unsafe(text: string): string {
  return text.startsWith("'") && FORMULA.test(text.slice(1)) ? text.slice(1) : text;
}
