// Before the tests of the site: builds it, once. Some tests import modules of it.
import { buildSite } from "../../../tools/build_site.mjs";

export default () => buildSite();
