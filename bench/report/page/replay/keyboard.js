// Keys of the replay, while anything in it has the focus. Controls that need a key themselves keep it.
import { element } from '../elements.js';

const kTurn = Math.PI / 36, kZoom = 1.2;

// [keys as the browser calls them, what is written in the help, what they do, what happens]
function bindings(replay) {
    const { player, viewpoint } = replay;
    return [
        [[' '], 'Space', 'play or pause', () => player.toggle()],
        [['ArrowLeft'], '←', 'one frame back', () => player.go(player.place - 1)],
        [['ArrowRight'], '→', 'one frame on', () => player.go(player.place + 1)],
        [['Home'], 'Home', 'first frame', () => player.go(0)],
        [['End'], 'End', 'last frame', () => player.go(player.frames.length - 1)],
        [['+', '='], '+', 'nearer', () => viewpoint.zoom(kZoom)],
        [['-'], '−', 'farther', () => viewpoint.zoom(1 / kZoom)],
        [['a'], 'A', 'turn left', () => viewpoint.orbit(-kTurn, 0)],
        [['d'], 'D', 'turn right', () => viewpoint.orbit(kTurn, 0)],
        [['w'], 'W', 'look from higher up', () => viewpoint.orbit(0, kTurn)],
        [['s'], 'S', 'look from lower down', () => viewpoint.orbit(0, -kTurn)],
        [['n'], 'N', 'pick the next body', () => replay.pickNext(1)],
        [['p'], 'P', 'pick the body before', () => replay.pickNext(-1)],
        [['f'], 'F', 'go to the first difference', () => replay.goToDifference()],
    ];
}

function needsItself(target, key) {
    if (target.tagName === 'SELECT' || target.type === 'number') return true;
    if (target.type === 'range') return key.startsWith('Arrow') || key === 'Home' || key === 'End';
    if (target.type === 'checkbox') return key === ' ';
    return (target.tagName === 'BUTTON' || target.tagName === 'SUMMARY') && key === ' ';
}

export function listen(region, replay) {
    const known = bindings(replay);
    region.addEventListener('keydown', event => {
        if (event.ctrlKey || event.altKey || event.metaKey || needsItself(event.target, event.key)) return;
        const found = known.find(([keys]) => keys.includes(event.key.toLowerCase()) || keys.includes(event.key));
        if (!found) return;
        event.preventDefault();
        found[3]();
    });
    return element('details', {}, element('summary', {}, 'Keys and mouse'),
        element('ul', {}, ...known.map(([, name, meaning]) => element('li', {}, element('kbd', {}, name), `: ${meaning}`)),
            element('li', {}, 'mouse: drag to turn, wheel to come nearer, right button to move, click to pick a body')));
}
