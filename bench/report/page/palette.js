// Colours that people with any common kind of colour blindness tell apart: Okabe and Ito, "Color Universal Design", 2008.
// Instead of their yellow, which vanishes on white, and black there is an indigo as in P. Tol's "Colour Schemes", 2021;
// grey is kept for what has no name.
const kColours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#56b4e9', '#e69f00', '#5d4ca5'];

export const kNeutral = '#9aa0a6';

export const kColourCount = kColours.length;

export function colour(index) {
    return kColours[index % kColours.length];
}

// Lines are told apart without their colours, too.
const kDashes = [[], [6, 3], [2, 2], [10, 3, 2, 3]];
const kMarks = ['circle', 'rect', 'triangle', 'rectRot', 'star', 'crossRot'];

export function dash(index) {
    return kDashes[index % kDashes.length];
}

export function mark(index) {
    return kMarks[index % kMarks.length];
}

// Returns the value of a variable of page.css in the colour scheme in force.
export function themeColour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function onThemeChange(listener) {
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', listener);
}
