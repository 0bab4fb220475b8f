/** Whether tests run in their long forms: effort.h, for those in JavaScript. */
export const isThorough = process.env.APOLLONIUS_THOROUGH !== undefined;
