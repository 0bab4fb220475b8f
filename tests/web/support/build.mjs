// Before the page's tests: some import modules of the page as it is built.
import { buildPage } from "../../../tools/build_page.mjs";

export default () => buildPage();
