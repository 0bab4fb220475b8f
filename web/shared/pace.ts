// How often what moves by itself is drawn. A screen can show 144 frames a second. A circle that
// goes its way slowly needs no more than 30, and each costs the reader's processor something.

const kBetween = 1000 / 30; // ms
const kSlack = 1; // ms: a screen's frames come a little early or late

/** Whether a frame is to be drawn. @param last when one was drawn; both in ms */
export const isDue = (now: number, last: number) => now - last > kBetween - kSlack;
