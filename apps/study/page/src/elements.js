/** An element with a text, which is never read as HTML, and attributes. */
export function element(tag, text = '', attributes = {}) {
  const made = document.createElement(tag);
  made.textContent = text;
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

/** A list of terms and their values. */
export const definitions = (rows) =>
  rows.flatMap(([term, value]) => [element('dt', term), element('dd', value)]);
