// Loads the page's scripts and the package. If one of them is missing nothing else could say so:
// this one needs no other.
try {
  const { start } = await import("./start.js");
  await start();
} catch (error) {
  console.error(error);
  const notice = document.getElementById("notice");
  if (notice) {
    notice.textContent =
      `The diagram could not be started: ${error instanceof Error ? error.message : error} ` +
      "(If files are missing, the page has not been built: npm start.)";
    notice.hidden = false;
  }
}

export {}; // a module, which may wait
