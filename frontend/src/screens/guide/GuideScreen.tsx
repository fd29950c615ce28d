import { useEffect, useRef } from "preact/hooks";
import { Button, Loading, PageHead, Problem } from "../../components";
import { query } from "../../core/address";
import { language, say } from "../../core/messages";
import { useResource } from "../../core/resource";
import { GUIDE_PAGES, type GuidePageName, isGuidePage, readPage } from "./pages";
import "./guide.css";

/** The guide: pages written as Markdown in docs/, the one that the address names. */
export default function GuideScreen() {
  const asked = query.value.get("page") ?? GUIDE_PAGES[0];
  const section = query.value.get("section");
  const name: GuidePageName = isGuidePage(asked) ? asked : GUIDE_PAGES[0];
  const spoken = language.value;
  const page = useResource(() => readPage(name, spoken), [name, spoken], { keep: true });
  const text = useRef<HTMLElement>(null);
  useEffect(() => {
    const place = section ? text.current?.querySelector(`#guide-${CSS.escape(section)}`) : null;
    if (place) place.scrollIntoView();
    else document.getElementById("main")?.scrollTo(0, 0);
  }, [page.data, section]);
  return (
    <div class="page page--alone guide">
      <PageHead says={`guide-page-${name}`}>
        <Button says="action-print" onClick={() => print()} />
      </PageHead>
      <div class="guide__columns">
        <nav class="guide__pages" aria-label={say("guide-pages")}>
          <ul>
            {GUIDE_PAGES.map((one) => (
              <li key={one}>
                <a href={`/guide?page=${one}`} aria-current={one === name ? "page" : undefined}>
                  {say(`guide-page-${one}`)}
                </a>
              </li>
            ))}
          </ul>
        </nav>
        {page.error !== null && <Problem error={page.error} again={page.reload} />}
        {page.data ? (
          // made from our own files when the pages are built, so nothing foreign can be in it
          <article
            class="guide__text"
            lang={page.data.language}
            ref={text}
            dangerouslySetInnerHTML={{ __html: page.data.html }}
          />
        ) : (
          page.error === null && <Loading what={say("guide-loading")} />
        )}
      </div>
    </div>
  );
}
