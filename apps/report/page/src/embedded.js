// What the program wrote into this page.

/** The record of the run: an object, see page_data.cpp. */
export const record = JSON.parse(document.getElementById('record').textContent);

/** The packed texts of the frames, some frames in each, in their order; the same for contacts. */
export const packedFrames = [...document.querySelectorAll('script.frames')];
export const packedContacts = [...document.querySelectorAll('script.contacts')];

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** The bytes that were deflated and written as base64. */
export async function unpack(base64) {
  const stream = new Blob([bytesOf(base64)]).stream();
  const inflated = stream.pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(inflated).arrayBuffer());
}

export const unpackFloats = async (base64) => new Float32Array((await unpack(base64)).buffer);
export const unpackIntegers = async (base64) => new Uint32Array((await unpack(base64)).buffer);
