// Runs one program in the sandbox of frame.html, and tells the page what it prints, what goes wrong
// and how high its picture is. The build puts it into frame.html.
{
  const tell = (told) => parent.postMessage(told, "*"); // the sandbox has no origin to name
  const addressOf = (text) => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));

  const textOf = (value) => {
    if (typeof value === "string") return value;
    if (ArrayBuffer.isView(value)) return textOf(Array.from(value));
    if (value instanceof Map) return `Map ${JSON.stringify([...value])}`;
    return JSON.stringify(value, null, 1)?.replace(/\s+/g, " ") ?? String(value);
  };
  for (const kind of ["log", "info", "warn", "error"])
    console[kind] = (...values) => tell({ kind: "print", text: values.map(textOf).join(" ") });

  const fail = (message, line) => tell({ kind: "failed", message, line });
  addEventListener("error", ({ error, message, lineno }) =>
    fail(String(error ?? message), error?.lineOfLoop ?? lineno),
  );
  addEventListener("unhandledrejection", ({ reason }) => fail(String(reason), reason?.lineOfLoop));

  const kLongest = 5; // seconds that loops may run without a pause, in which this page can answer
  let since = 0;
  globalThis.$turn = (lineOfLoop) => {
    const now = performance.now();
    if (since === 0) {
      since = now;
      setTimeout(() => {
        since = 0;
      });
    } else if (now - since > 1000 * kLongest) {
      const message = `the loop was stopped: it ran for more than ${kLongest} s`;
      throw Object.assign(new Error(message), { lineOfLoop });
    }
  };

  const script = (properties) =>
    document.head.appendChild(Object.assign(document.createElement("script"), properties));

  addEventListener("message", ({ source, data }) => {
    if (source !== parent) return;
    const { modules, style, program } = data;
    document.head.appendChild(document.createElement("style")).textContent = style;
    const imports = Object.fromEntries(
      Object.entries(modules).map(([name, text]) => [name, addressOf(text)]),
    );
    script({ type: "importmap", textContent: JSON.stringify({ imports }) });
    new ResizeObserver(() => {
      tell({ kind: "height", height: document.body.offsetHeight });
    }).observe(document.body);
    script({ type: "module", src: addressOf(program), onload: () => tell({ kind: "done" }) });
  });
  addEventListener("load", () => tell({ kind: "ready" }));
}
