// Buttons and choices of the replay.
import { choice, element } from '../elements.js';
import { kColourings } from './colouring.js';
import { kOverlays } from './overlays.js';

const kSpeeds = [['0.1', '1/10'], ['0.25', '1/4'], ['1', '1'], ['4', '4'], ['10', '10']];

// What all recordings hold can be shown.
function available(things, recordings) {
    return Object.entries(things).filter(([, { needs }]) => !needs || recordings.some(recording => recording.has[needs]));
}

export class Controls {
    constructor(replay, recordings, hasDifference) {
        this.button = element('button', { type: 'button', id: 'replay-play', onclick: () => replay.player.toggle() });
        const speed = choice('Speed, × real time', 'replay-speed', kSpeeds, value => { replay.player.speed = Number(value); });
        speed.querySelector('select').value = '1';
        const colours = available(kColourings, recordings).map(([name, { text }]) => [name, text]);
        if (recordings.length > 1) colours.push(['difference', 'difference']);
        this.meaning = element('span', { class: 'note' });
        const overlays = available(kOverlays, recordings).map(([name, { text }]) => element('label', {}, element('input',
            { type: 'checkbox', id: `replay-${name}`, onchange: event => replay.showOverlay(name, event.target.checked) }), ` ${text}`));
        const difference = element('button', { type: 'button', onclick: () => replay.goToDifference() }, 'Go to the first difference');
        this.body = element('input', { type: 'number', id: 'replay-body', min: 0, max: recordings[0].frames[0].bodies.length - 1,
            onchange: () => replay.pick(this.body.value in replay.player.frame.bodies ? Number(this.body.value) : null) });
        this.element = element('div', {},
            element('div', { class: 'controls' }, this.button, speed,
                choice('Colour by', 'replay-colour', colours, value => replay.colourBy(value)), this.meaning,
                element('span', {}, element('label', { for: 'replay-body' }, 'Picked body '), this.body)),
            element('div', { class: 'controls', role: 'group', 'aria-label': 'What is drawn over the bodies' }, ...overlays,
                ...(hasDifference ? [difference] : [])));
    }

    show({ player, picked }, meaning) {
        this.button.textContent = player.playing ? 'Pause' : 'Play';
        this.meaning.textContent = meaning;
        this.body.value = picked ?? '';
    }
}
