/** What the program wrote into this page: results.json of the study. */
export const results = JSON.parse(document.getElementById('results').textContent);

export const variants = results.variants;
export const byName = new Map(variants.map((variant) => [variant.name, variant]));
