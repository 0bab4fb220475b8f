// npm start: sets up, builds the package and the site, and serves it until it is stopped. The site
// is built again when its files change.
//
//   npm start -- --port 8080
//   PORT=8080 npm start
import { buildPackage } from "./build.mjs";
import { watchSite } from "./build_site.mjs";
import { serveSite } from "./serve.mjs";
import { main } from "./toolchain/setup.mjs";

await main(async () => {
  await buildPackage();
  await watchSite();
  await serveSite();
});
