// Search, buttons that copy code, and the service worker. A plain script, so that the site also works when its files
// are opened without a server.

(() => {
  const root = new URL(document.documentElement.dataset.root, location.href);
  const input = document.getElementById('search');
  const list = document.getElementById('found');
  let chosen = -1;

  function choose(index) {
    const items = [...list.children];
    chosen = items.length ? (index + items.length) % items.length : -1;
    items.forEach((item, i) => item.setAttribute('aria-selected', String(i === chosen)));
    if (chosen >= 0) {
      input.setAttribute('aria-activedescendant', items[chosen].id);
      items[chosen].scrollIntoView({ block: 'nearest' });
    } else input.removeAttribute('aria-activedescendant');
  }

  function show() {
    const found = globalThis.hgpSearch.rank(input.value, 12);
    list.replaceChildren(
      ...found.map(({ file, title, heading, id, extract }, index) => {
        const item = document.createElement('li');
        item.id = `found-${index}`;
        item.role = 'option';
        const link = document.createElement('a');
        link.tabIndex = -1;
        link.href = new URL(file + (id ? `#${id}` : ''), root).href;
        const name = document.createElement('b');
        name.textContent = heading && heading !== title ? `${title} › ${heading}` : title;
        const small = document.createElement('small');
        small.textContent = extract;
        link.append(name, small);
        item.append(link);
        return item;
      }),
    );
    if (input.value.trim() && found.length === 0) {
      const none = document.createElement('li');
      none.textContent = `Nothing has “${input.value.trim()}”.`;
      list.append(none);
    }
    list.hidden = !input.value.trim();
    input.setAttribute('aria-expanded', String(!list.hidden));
    choose(found.length ? 0 : -1);
  }

  input.addEventListener('input', show);
  input.addEventListener('focus', show);
  input.addEventListener('keydown', (event) => {
    if (event.key === 'ArrowDown') choose(chosen + 1);
    else if (event.key === 'ArrowUp') choose(chosen - 1);
    else if (event.key === 'Enter') list.children[chosen]?.querySelector('a')?.click();
    else if (event.key === 'Escape') {
      input.value = '';
      show();
    } else return;
    event.preventDefault();
  });
  document.addEventListener('click', (event) => {
    if (!event.target.closest('.search')) list.hidden = true;
  });
  document.addEventListener('keydown', (event) => {
    if (event.key !== '/' || event.target.closest('input, select, textarea')) return;
    event.preventDefault();
    input.focus();
  });

  if (navigator.clipboard)
    for (const block of document.querySelectorAll('pre')) {
      const text = block.textContent;
      const button = document.createElement('button');
      button.className = 'copy';
      button.textContent = 'Copy';
      button.addEventListener('click', async () => {
        await navigator.clipboard.writeText(text);
        button.textContent = 'Copied';
        setTimeout(() => (button.textContent = 'Copy'), 1500);
      });
      block.prepend(button);
    }

  if ('serviceWorker' in navigator && location.protocol.startsWith('http'))
    navigator.serviceWorker.register(new URL('sw.js', root), { scope: root }).catch(() => {});
})();
