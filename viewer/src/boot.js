// Reads the page's data and then starts the page: all other modules take the data as there.
import { $ } from './basics.js';
import { unpack } from './data.js';

unpack().then(() => import('./main.js')).catch(e => {
  $('stage').textContent = `This browser cannot read the page's data (${e.message || e}). The tables hold all figures.`;
  console.error(e);
});
