// Elements of the page. Texts of the data become text nodes, never markup.

export function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
        else if (value === true) made.setAttribute(key, '');
        else if (value !== false && value !== undefined) made.setAttribute(key, value);
    }
    made.append(...children);
    return made;
}

// A table whose first column names its rows.
export function table(caption, heads, rows) {
    const head = element('tr', {}, ...heads.map(text => element('th', { scope: 'col' }, text)));
    const body = rows.map(([name, ...cells]) => element('tr', {},
        element('th', { scope: 'row' }, name), ...cells.map(text => element('td', {}, text))));
    return element('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': caption },
        element('table', { class: 'figures' },
            element('caption', {}, caption), element('thead', {}, head), element('tbody', {}, ...body)));
}

// A part of the page with a heading, and a link to it in the contents.
export function section(id, title, ...children) {
    const made = element('section', { id, 'aria-labelledby': `${id}-title` }, element('h2', { id: `${id}-title` }, title), ...children);
    document.getElementById('main').append(made);
    document.getElementById('contents').append(element('li', {}, element('a', { href: `#${id}` }, title)));
    return made;
}

// A labelled choice; `onChoice` gets its value.
export function choice(label, id, options, onChoice) {
    const select = element('select', { id, onchange: () => onChoice(select.value) },
        ...options.map(([value, text]) => element('option', { value }, text)));
    return element('span', {}, element('label', { for: id }, `${label} `), select);
}
