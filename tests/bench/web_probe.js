// Put into every page before its own code: when keys and buttons went down and up, when a new picture was drawn
// on the frame's canvas, and when the answer to a POST was there. All times by the page's own clock, in ms.
(() => {
  const probe = { keys: [], clicks: [], pictures: [], posts: [] };
  window.__probe = probe;
  addEventListener("keydown", (event) => probe.keys.push(event.timeStamp), true);
  addEventListener("pointerup", (event) => probe.clicks.push(event.timeStamp), true);

  const drawImage = CanvasRenderingContext2D.prototype.drawImage;
  let last = null;
  CanvasRenderingContext2D.prototype.drawImage = function (picture, ...where) {
    drawImage.call(this, picture, ...where);
    const frame = this.canvas.parentElement?.dataset.testid === "frame-view";
    if (!frame || picture === last) return;
    last = picture;
    probe.pictures.push({ at: performance.now(), width: picture.width });
  };

  const fetch = window.fetch;
  window.fetch = async (...wanted) => {
    const answer = await fetch(...wanted);
    const method = wanted[1]?.method ?? wanted[0]?.method ?? "GET";
    if (method === "POST") probe.posts.push({ at: performance.now(), url: answer.url, status: answer.status });
    return answer;
  };
})();
