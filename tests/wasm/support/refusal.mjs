// Refusals: what a call throws when it is given what it cannot take.
import { ApolloniusError } from "../../../build/packed/consumer.mjs";

/** Expects a typed error of this code whose message contains this text; returns it. */
export function expectRefusal(call, code, message) {
  let error;
  try {
    call();
  } catch (thrown) {
    error = thrown;
  }
  return expectTyped(error, code, message);
}

/** Expects a call to return a promise that is rejected; the call itself throws nothing. */
export async function expectRejection(call, code, message) {
  const error = await call().then(
    () => undefined,
    (thrown) => thrown,
  );
  return expectTyped(error, code, message);
}

function expectTyped(error, code, message) {
  expect(error).toBeInstanceOf(ApolloniusError);
  expect({ code: error.code, message: error.message }).toEqual({
    code,
    message: expect.stringContaining(message),
  });
  return error;
}
