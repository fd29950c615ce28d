/** Scrolls the row's own list so far that the row is seen and the list begins with a whole one, and nothing else: a page
 * that scrolled too would take the picture from under the pointer. */
export function bringInSight(row: Element | null | undefined): void {
  let list = row?.parentElement;
  while (list && !(list.scrollHeight > list.clientHeight && scrolls(list))) list = list.parentElement;
  if (!row || !list || list.id === "main") return;
  const [seen, place] = [list.getBoundingClientRect(), row.getBoundingClientRect()];
  if (place.top < seen.top) list.scrollTop -= seen.top - place.top;
  else if (place.bottom > seen.bottom) {
    list.scrollTop += place.bottom - seen.bottom;
    const first = document.elementFromPoint(place.left + 1, seen.top + 1)?.closest(row.localName);
    if (!first || first === row || !list.contains(first)) return;
    const { top, bottom } = first.getBoundingClientRect();
    if (top < seen.top && bottom > seen.top) list.scrollTop += bottom - seen.top;
  }
}

function scrolls(element: Element): boolean {
  return /auto|scroll/.test(getComputedStyle(element).overflowY);
}
