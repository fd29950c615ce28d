/** Scrolls the list of a box so far that its row `[name="id"]` is seen and the list begins with a whole one, and nothing
 * else: a page that scrolled too would take the picture from under the pointer. `name` marks every row. */
export function bringInSight(box: Element | null, name: string, id: number | null): void {
  const row = box?.querySelector(`[${name}="${id}"]`);
  let list = row?.parentElement;
  while (list && !(list.scrollHeight > list.clientHeight && scrolls(list))) list = list.parentElement;
  if (!box || !row || !list || list.id === "main") return;
  const [seen, place] = [list.getBoundingClientRect(), row.getBoundingClientRect()];
  const begin = Math.max(seen.top, ...[...list.querySelectorAll("thead th")].map(bottomIfItStays));
  if (place.top < begin) list.scrollTop -= begin - place.top;
  else if (place.bottom > seen.bottom) {
    list.scrollTop += place.bottom - seen.bottom;
    const rows = [...box.querySelectorAll(`[${name}]`)];
    const before = rows.slice(0, rows.indexOf(row)).reverse();
    const cut = before.find((one) => one.getBoundingClientRect().top < begin);
    if (cut) list.scrollTop += Math.max(0, cut.getBoundingClientRect().bottom - begin);
  }
}

function bottomIfItStays(head: Element): number {
  return getComputedStyle(head).position === "sticky" ? head.getBoundingClientRect().bottom : -Infinity;
}

function scrolls(element: Element): boolean {
  return /auto|scroll/.test(getComputedStyle(element).overflowY);
}
