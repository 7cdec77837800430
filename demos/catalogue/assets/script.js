// Search and filters, clips that play while they are seen, and the lecture. Pages say all they have
// to say without it.
'use strict';

const all = (selector, root = document) => [...root.querySelectorAll(selector)];
const reduced = matchMedia('(prefers-reduced-motion: reduce)');

// Clips play while they are seen; who asked for less motion starts them by hand.
function watchClips() {
    const seen = new IntersectionObserver(entries => {
        for (const {target, isIntersecting} of entries)
            if (!isIntersecting) target.pause();
            else if (!reduced.matches) target.play().catch(() => {});
    }, {threshold: 0.25});
    for (const clip of all('video[data-autoplay]')) seen.observe(clip);
}

// Every word that is typed begins or is a part of a word of the item.
const plain = text => text.toLowerCase().normalize('NFD').replace(/[\u0300-\u036f]/g, '');
const hasWords = (item, words) => {
    const text = plain(item.dataset.words + ' ' + item.textContent);
    return words.every(word => text.includes(word));
};

function filter(form) {
    const search = form.elements.search;
    const facets = all('[data-facet]', form);
    const cards = all('.card'), others = all('.other li'), rows = all('table.words tbody tr');
    const found = form.querySelector('[role=status]');

    const show = () => {
        const words = plain(search.value).split(/\s+/).filter(Boolean);
        const chosen = facets.filter(facet => facet.value);
        let count = 0;
        for (const card of cards) {
            card.hidden = !(hasWords(card, words) && chosen.every(facet =>
                card.dataset[facet.dataset.facet].split(' ').includes(facet.value)));
            count += !card.hidden;
        }
        for (const row of rows) {
            row.hidden = !hasWords(row, words);
            count += !row.hidden;
        }
        let besides = 0;
        for (const item of others) {
            item.hidden = !words.length || !hasWords(item, words);
            besides += !item.hidden;
        }
        for (const section of all('.other')) section.hidden = !besides;
        const thing = rows.length ? 'word' : 'scene';
        found.textContent = words.length || chosen.length
            ? `${count} ${thing}${count === 1 ? '' : 's'}` + (besides ? `, ${besides} other pages` : '')
            : '';
    };
    const remember = () => {
        const words = new URLSearchParams();
        if (search.value) words.set('search', search.value);
        for (const facet of facets) if (facet.value) words.set(facet.dataset.facet, facet.value);
        history.replaceState(null, '', '#' + words);
    };
    const recall = () => {
        if (!location.hash.includes('=')) return;
        const words = new URLSearchParams(location.hash.slice(1));
        search.value = words.get('search') ?? '';
        for (const facet of facets) facet.value = words.get(facet.dataset.facet) ?? '';
        show();
    };
    form.hidden = false;
    form.addEventListener('input', () => { show(); remember(); });
    form.addEventListener('submit', event => event.preventDefault());
    form.addEventListener('reset', () => setTimeout(() => { show(); remember(); }));
    addEventListener('hashchange', recall);
    recall();
}

// One thing at a time: a card, or a section; the next page after the last.
const lecture = {
    at: -1,
    slides: () => all('.slide').filter(slide => !slide.hidden),

    begin(at = 0) {
        const slides = this.slides();
        if (!slides.length) return;
        document.body.classList.add('lecture');
        if (!document.querySelector('.lecture-bar')) {
            const bar = document.createElement('div');
            bar.className = 'lecture-bar';
            bar.innerHTML = '<button type="button" data-do="back">← Back</button>' +
                '<span role="status"></span><button type="button" data-do="next">Next →</button>' +
                '<button type="button" data-do="end">End (Esc)</button>';
            bar.addEventListener('click', event => {
                const what = event.target.dataset?.do;
                if (what === 'next') this.step(1);
                if (what === 'back') this.step(-1);
                if (what === 'end') this.end();
            });
            document.body.append(bar);
        }
        this.show(at < 0 ? slides.length + at : at);
    },
    show(at) {
        const slides = this.slides();
        this.at = Math.max(0, Math.min(at, slides.length - 1));
        slides.forEach((slide, i) => slide.classList.toggle('shown', i === this.at));
        document.querySelector('.lecture-bar span').textContent =
            `${document.title.split(' · ')[0]}: ${this.at + 1} of ${slides.length}`;
        scrollTo(0, 0);
    },
    step(by) {
        const to = this.at + by, body = document.body.dataset;
        if (to >= 0 && to < this.slides().length) this.show(to);
        else if (by > 0 && body.next) location.href = body.next + '#lecture';
        else if (by < 0 && body.previous) location.href = body.previous + '#lecture-end';
    },
    end() {
        if (document.fullscreenElement) document.exitFullscreen();
        document.body.classList.remove('lecture');
        document.querySelector('.lecture-bar')?.remove();
        this.slides()[this.at]?.scrollIntoView();
        this.at = -1;
    },
    get on() { return this.at >= 0; },
};

function help() {
    const open = document.querySelector('dialog');
    if (open) return open.close();
    const dialog = document.createElement('dialog');
    dialog.setAttribute('aria-label', 'Keys');
    dialog.innerHTML = '<h2>Keys</h2><dl>' +
        [['/', 'search'], ['l', 'lecture: one thing at a time'], ['→ Space', 'the next thing'],
         ['←', 'the one before'], ['f', 'full screen'], ['p', 'play or pause the clip'],
         ['Esc', 'end of the lecture'], ['?', 'this']]
            .map(([key, words]) => `<dt><kbd>${key}</kbd></dt><dd>${words}</dd>`).join('') +
        '</dl><form method="dialog"><button>Close</button></form>';
    dialog.addEventListener('close', () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
}

const keys = {
    '/': () => (document.querySelector('.filter input') ?? document.querySelector('.top a')).focus(),
    'l': () => lecture.on ? lecture.end() : lecture.begin(),
    'f': () => document.fullscreenElement ? document.exitFullscreen()
                                          : document.documentElement.requestFullscreen?.().catch(() => {}),
    'p': () => {
        const clip = document.querySelector('.shown video') ?? document.querySelector('video');
        if (clip) clip.paused ? clip.play() : clip.pause();
    },
    '?': help,
};
const lectureKeys = {
    'ArrowRight': () => lecture.step(1), 'PageDown': () => lecture.step(1), ' ': () => lecture.step(1),
    'ArrowLeft': () => lecture.step(-1), 'PageUp': () => lecture.step(-1),
    'Home': () => lecture.show(0), 'End': () => lecture.show(Infinity), 'Escape': () => lecture.end(),
};

addEventListener('keydown', event => {
    if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector('dialog[open]')) return;
    if (event.target.closest('input, select, textarea')) return;
    if (event.key === ' ' && event.target.closest('button, a, video')) return;
    const act = (lecture.on && lectureKeys[event.key]) || keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
});

watchClips();
all('form.filter').forEach(filter);
const lectureByAddress = () => {
    if (location.hash === '#lecture') lecture.begin();
    if (location.hash === '#lecture-end') lecture.begin(-1);
};
addEventListener('hashchange', lectureByAddress);
lectureByAddress();
