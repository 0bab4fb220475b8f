// npm run site: sets up, builds the package and the site, and says where that is: build/web/, which
// any static server can hand out, from any folder.
import { buildPackage } from "./build.mjs";
import { buildSite, builtSite } from "./build_site.mjs";
import { main } from "./toolchain/setup.mjs";

await main(async () => {
  await buildPackage();
  await buildSite();
  console.log(`The site is in ${builtSite}`);
});
