// What is on the screen before any script has run: the start page as HTML, in the words of panels/start_page.ts, which
// takes its place. Buttons wait for the script.

const escaped = (text) =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

const card = ({ id, title, hint }) => `<li><button type="button" class="card" disabled>
<img src="./thumbnails/${escaped(id)}.png" width="120" height="120" alt="" loading="lazy" />
<b>${escaped(title)}</b><small>${escaped(hint)}</small></button></li>`;

/** `examples`: { id, title, hint } of each. */
export const firstScreen = (examples) => `<header>
<button type="button" disabled>Open</button>
</header>
<main id="first" class="no-model">
<section class="empty" aria-label="Start">
<div class="hero">
<div class="turning"></div>
<div class="pitch">
<h2><span class="for-mouse">Drop</span><span class="for-fingers">Open</span> a mesh</h2>
<p class="lead">It comes back with texture coordinates that continue across every seam, without folds.</p>
<p>GLB, glTF, OBJ, PLY, STL, OFF, a folder or a ZIP.<br />Files stay on this computer.</p>
<p class="row">
<button type="button" class="primary" disabled>Choose files</button>
<button type="button" disabled>Choose a folder</button>
</p>
</div>
</div>
<h3>or try an example</h3>
<ul class="cards">
${examples.map(card).join('\n')}
</ul>
</section>
</main>`;
