"""How the report is set: Typst's source. It lays out blocks; what stands in them comes as JSON."""

from __future__ import annotations

from sightline.export.report.template_method import METHOD

_PAGE = r"""
#let doc = json("report.json")
#let ink = luma(7%)
#let muted = luma(38%)
#let hair = 0.4pt + luma(60%)
#let measure = 134mm

#let gap = "\u{200b}" // where a long run may be broken; not to be written, for readers search the words
#let t(words) = if words.contains(gap) { words.split(gap).join(box(width: 0pt)) } else { words }
#let plain(words) = words.replace(gap, "")

#set document(title: plain(doc.title) + ", measurement report", author: "Sightline")
#set text(font: ("Libertinus Serif", "DejaVu Sans"), size: 10pt, fill: ink, lang: "en", hyphenate: true)
#set par(leading: 0.62em, spacing: 0.85em)
#set heading(numbering: "1")
#show math.equation: set text(font: "New Computer Modern Math", size: 10pt)
#show raw: set text(font: "DejaVu Sans Mono", size: 7.6pt)

#set page(
  paper: "a4",
  margin: (left: 18mm, right: 18mm, top: 23mm, bottom: 20mm),
  header: context if here().page() > 1 {
    set text(size: 8.5pt, fill: muted)
    grid(columns: (1fr, auto), gutter: 8mm,
      t(doc.short), [Measurement report])
    v(-0.5em)
    line(length: 100%, stroke: hair)
  },
  footer: context {
    set text(size: 8.5pt, fill: muted, number-width: "tabular")
    grid(columns: (1fr, auto), gutter: 8mm,
      [State of #doc.as_of#if doc.head != "" [, audit head #doc.head…]],
      [Page #counter(page).display() of #counter(page).final().first()])
  },
)

#show heading.where(level: 1): it => block(above: 2.1em, below: 0.9em, sticky: true, {
  set text(size: 14pt, weight: 600)
  box(width: 8mm, counter(heading).display("1"))
  it.body
})
#show heading.where(level: 2): it => block(above: 1.6em, below: 0.75em, sticky: true, {
  set text(size: 11pt, weight: 600)
  it.body
})
#show figure: set block(breakable: true, above: 1.7em, below: 1.7em)
#let short-rows = 16 // a table of so many rows stays on one page
#show figure: set align(left)
#show figure.where(kind: table): set figure.caption(position: top)
#set figure(gap: 0.75em)
#show figure.caption: it => layout(room => block(width: calc.min(room.width, measure), {
  set text(size: 9pt, hyphenate: false)
  strong[#it.supplement #context it.counter.display(it.numbering)]
  h(0.6em)
  it.body
}))

#let small(body) = text(size: 8.5pt, fill: muted, body)
#let hashed(body) = text(font: "DejaVu Sans Mono", size: 7pt, body)
#let cell(parts) = {
  t(parts.at(0))
  if parts.len() > 1 { linebreak(); text(size: 7.8pt, fill: muted, t(parts.at(1))) }
}
"""

_BLOCKS = r"""
#let title-block(b) = {
  block(below: 1.1em, text(size: 9pt, fill: muted, tracking: 0.08em, upper[Measurement report]))
  block(below: 1.1em, par(leading: 0.45em, text(size: 24pt, weight: 600, hyphenate: false, t(doc.title))))
  if doc.site != "" { block(text(size: 13pt, fill: muted, t(doc.site))) }
  block(above: 1.2em, below: 1.3em, line(length: 100%, stroke: 0.9pt + ink))
}
#let pairs-block(b) = block(below: 1.2em, breakable: false, grid(
  columns: (38mm, 1fr), row-gutter: 0.62em, column-gutter: 4mm,
  ..b.rows.map(row => (text(fill: muted, row.at(0)), t(row.at(1)))).flatten(),
))
#let table-block(b) = {
  set text(size: 9pt, number-width: "tabular", hyphenate: false)
  set par(leading: 0.48em)
  let widths = b.columns.map(c => if c.at(1) == 0 { auto } else { c.at(1) * 1fr })
  let sides = b.columns.map(c => if c.at(2) == "right" { right } else { left })
  let set-cell(x, parts) = {
    if b.columns.at(x).at(2) == "hash" { hashed(plain(parts.at(0))) } else { cell(parts) }
  }
  let wide = b.columns.any(c => c.at(1) != 0)
  show figure: set block(breakable: b.rows.len() > short-rows)
  if b.rows.len() > short-rows {
    // Room for caption, head and a few rows, or else the next page.
    block(height: 36mm, above: 0pt, below: 0pt, breakable: false)
    v(-36mm)
  }
  figure(kind: table, caption: t(b.caption), block(width: if wide { 100% } else { auto }, table(
    columns: widths,
    align: (x, y) => sides.at(x) + if y == 0 { bottom } else { top },
    inset: (x, y) => (
      left: if x == 0 { 0pt } else { 4.5pt },
      right: if x == sides.len() - 1 { 0pt } else { 4.5pt },
      top: 3.2pt, bottom: 3.2pt),
    stroke: none,
    table.hline(stroke: 0.8pt + ink),
    table.header(repeat: true, ..b.columns.map(c => {
      text(weight: 600, size: 8.5pt, c.at(0))
      if c.at(3) != "" { linebreak(); text(size: 8pt, fill: muted, c.at(3)) }
    })),
    table.hline(stroke: 0.4pt + ink),
    ..b.rows.map(row => row.enumerate().map(((x, parts)) => set-cell(x, parts))).flatten(),
    table.hline(stroke: 0.8pt + ink),
  )))
}
#let figures-block(b) = block(breakable: true, grid(
  columns: (1fr,) * b.across, column-gutter: 6mm, row-gutter: 5mm,
  ..b.figures.map(f => block(breakable: false, figure(
    kind: image,
    caption: {
      text(weight: 600, t(f.title))
      if f.caption != "" { [. ] + text(fill: muted, t(f.caption)) }
    },
    image(f.file, alt: plain(f.title + ". " + f.caption), width: 100%, fit: "contain",
      height: if b.across > 1 and f.file.starts-with("photo") { 62mm } else { auto }),
  ))),
))
#let warning-block(b) = block(
  width: measure, inset: (left: 3mm, y: 1mm), stroke: (left: 1.6pt + ink), text(size: 9pt, t(b.text)))
#let code-block(b) = block(
  width: 100%, inset: 3mm, fill: luma(95%),
  par(leading: 0.55em, b.lines.map(l => raw(plain(l))).join(linebreak())))

#show grid: set block(above: 0.9em)
#for b in doc.blocks {
  if b.kind == "title" { title-block(b) }
  else if b.kind == "section" { heading(level: 1, b.text) }
  else if b.kind == "subsection" { heading(level: 2, numbering: none, t(b.text)) }
  else if b.kind == "words" { block(width: measure, sticky: b.sticky, t(b.text)) }
  else if b.kind == "note" { block(width: measure, small(t(b.text))) }
  else if b.kind == "warning" { warning-block(b) }
  else if b.kind == "list" { block(width: measure, list(marker: [–], ..b.items.map(t))) }
  else if b.kind == "pairs" { pairs-block(b) }
  else if b.kind == "code" { code-block(b) }
  else if b.kind == "table" { table-block(b) }
  else if b.kind == "figures" { figures-block(b) }
  else if b.kind == "method" { method-block() }
}
"""

TEMPLATE = _PAGE + METHOD + _BLOCKS
