/** Whether tests run in their long forms (`npm run check -- page`). */
export const isThorough = process.env.APOLLONIUS_THOROUGH !== undefined;
