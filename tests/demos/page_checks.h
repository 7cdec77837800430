// What a page in a browser is asked, as bodies of functions for Browser::run(): "" where all is
// well.
#pragma once

#include <string>

namespace plait::test {

// Words that are too faint for who sees badly: WCAG 2.1, 4.5 to 1, 3 to 1 where they are large.
inline const std::string faintWords = R"(
    const numbers = color => color.match(/[\d.]+/g).map(Number);
    const linear = c => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
    const light = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
    const behind = element => {
        for (let e = element; e; e = e.parentElement) {
            const color = numbers(getComputedStyle(e).backgroundColor);
            if (color.length < 4 || color[3] === 1) return color;
        }
        return [255, 255, 255];
    };
    const faint = new Set();
    const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walk.nextNode()) {
        const element = walk.currentNode.parentElement;
        if (!walk.currentNode.data.trim() || !element.checkVisibility()) continue;
        const style = getComputedStyle(element);
        const color = element instanceof SVGElement ? style.fill : style.color;
        const [a, b] = [light(numbers(color)), light(behind(element))].sort((x, y) => y - x);
        const ratio = (a + 0.05) / (b + 0.05), size = parseFloat(style.fontSize);
        const large = size >= 24 || (size >= 18.7 && style.fontWeight >= 700);
        if (ratio < (large ? 3 : 4.5))
            faint.add(element.tagName + '.' + element.getAttribute('class') + ' ' + ratio.toFixed(2));
    }
    return [...faint].join('; ');
)";

// What keys cannot reach, or has no name that can be read out.
inline const std::string unnamed = R"(
    const bad = [];
    for (const e of document.querySelectorAll('a, button, input, select, video, [tabindex], svg')) {
        const label = e.getAttribute('aria-label') || e.getAttribute('aria-labelledby') ||
            e.textContent.trim() || e.labels?.[0]?.textContent.trim() ||
            e.querySelector('img')?.alt;
        if (!label && e.id !== 'content') bad.push(e.outerHTML.slice(0, 80));
    }
    for (const e of document.querySelectorAll('*'))
        if (e.scrollWidth > e.clientWidth + 1 && e.checkVisibility() &&
            /auto|scroll/.test(getComputedStyle(e).overflowX) && e.tabIndex < 0 &&
            e.localName !== 'math')
            bad.push('scrolls, and no key gets there: ' + e.outerHTML.slice(0, 80));
    let level = 0;
    for (const e of document.querySelectorAll('h1, h2, h3, h4')) {
        const now = Number(e.localName[1]);
        if (now > level + 1) bad.push('a heading skips: ' + e.textContent);
        level = now;
    }
    return bad.join('\n');
)";

}  // namespace plait::test
