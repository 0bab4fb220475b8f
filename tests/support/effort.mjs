/** Do tests run in their long forms? As effort.h, for tests in JavaScript. */
export const isThorough = process.env.APOLLONIUS_THOROUGH !== undefined;
