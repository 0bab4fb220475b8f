// Loads the page's scripts and the package. If one of them is missing nothing else could say so.
import { notify } from "./ui/notice.js";

try {
  const { start } = await import("./start.js");
  await start();
} catch (error) {
  console.error(error);
  notify(
    `The diagram could not be started: ${error.message} ` +
      "(If dist/ is missing, the package has not been built: npm run build.)",
    { stays: true },
  );
}
