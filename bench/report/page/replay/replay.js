// The replay: one or two recordings of a world in three dimensions, frame by frame.
import { element, section } from '../elements.js';
import { onThemeChange } from '../palette.js';
import { followAddress } from './address.js';
import { boundsOfMotion } from './bounds.js';
import { kColourings, kDifferenceColours } from './colouring.js';
import { Controls } from './controls.js';
import { bodyDiffers, compareRecordings, differenceText } from './difference.js';
import { Inspector } from './inspector.js';
import { listen } from './keyboard.js';
import { kOverlays } from './overlays.js';
import { Player } from './player.js';
import { bodyText, missingParts, titleOf } from './recording.js';
import { Stage } from './stage.js';
import { Timeline } from './timeline.js';
import { Viewpoint } from './viewpoint.js';

export class Replay {
    constructor(recordings) {
        this.recordings = recordings;
        this.bounds = boundsOfMotion(recordings[0]);
        this.comparison = recordings.length > 1 ? compareRecordings(...recordings) : null;
        this.colouring = recordings[0].has.clusters ? 'cluster' : 'body';
        this.shownOverlays = new Set();
        this.picked = null;
        const titles = recordings.map(titleOf);
        const canvases = titles.map((title, i) => element('canvas', { tabindex: '0', role: 'application', id: `replay-canvas-${i}`,
            'aria-label': `${recordings[0].header.world} in three dimensions: ${title}. Space plays, arrows step, N picks a body.` }));
        this.stages = recordings.map((recording, i) => new Stage(canvases[i], recording, this.bounds));
        this.player = new Player(recordings[0].frames, () => this.update());
        this.viewpoint = new Viewpoint(this.bounds, canvases, () => this.redraw());
        this.timeline = new Timeline(recordings[0], this.comparison?.first, place => this.player.go(place));
        this.controls = new Controls(this, recordings, Boolean(this.comparison?.first));
        this.inspector = new Inspector(recordings);
        this.status = element('p', { role: 'status', class: 'note' });
        this.region = this.addTo(section('replay', `Replay: ${recordings[0].header.world}`), titles, canvases);
        document.getElementById('replay-colour').value = this.colouring;
        this.pickByMouse(canvases);
        onThemeChange(() => this.redraw());
        addEventListener('resize', () => this.redraw());
        this.update();
        followAddress(this, location.hash);
    }

    addTo(parent, titles, canvases) {
        for (const { otherWorld } of this.recordings.filter(recording => recording.otherWorld))
            parent.append(element('p', { class: 'warning', role: 'alert', id: 'replay-worlds' }, otherWorld));
        if (this.comparison)
            parent.append(element('p', { class: this.comparison.first ? 'warning' : 'summary', id: 'replay-difference' },
                differenceText(this.comparison, this.recordings[0])));
        const pictures = element('div', { class: 'pictures' }, ...canvases.map((canvas, i) => element('figure', {},
            canvas, element('figcaption', {}, titles[i]))));
        parent.append(pictures, this.timeline.element, this.controls.element, this.status, this.inspector.element, listen(parent, this),
            ...this.recordings.map(recording => element('p', { class: 'note' },
                `Not recorded in ${recording.name}: ${missingParts(recording).join('; ')}.`)));
        return parent;
    }

    // A drag turns the view; only a click picks.
    pickByMouse(canvases) {
        canvases.forEach((canvas, i) => {
            let start = null;
            canvas.addEventListener('mousedown', event => { start = [event.clientX, event.clientY]; });
            canvas.addEventListener('click', event => {
                const moved = start && Math.hypot(event.clientX - start[0], event.clientY - start[1]) > 3;
                if (!moved) this.pick(this.stages[i].bodyAt(event.clientX, event.clientY, this.viewpoint.camera));
            });
        });
    }

    get frames() {
        const { number } = this.player.frame;
        return this.recordings.map(recording => recording.byNumber.get(number) ?? null);
    }

    pick(body) {
        this.picked = body;
        this.update();
    }

    pickNext(step) {
        const count = this.player.frame.bodies.length;
        if (count > 0) this.pick(this.picked === null ? (step > 0 ? 0 : count - 1) : (this.picked + step + count) % count);
    }

    colourBy(colouring) {
        this.colouring = colouring;
        this.update();
    }

    showOverlay(name, isShown) {
        this.shownOverlays[isShown ? 'add' : 'delete'](name);
        this.update();
    }

    goToDifference() {
        const first = this.comparison?.first;
        if (!first) return;
        this.player.pause();
        this.player.goToNumber(first.frame);
        this.pick(first.body);
    }

    colouringOf(frame, i) {
        if (this.colouring === 'difference') {
            const twin = this.frames[1 - i];
            return (_, body) => body >= 0 && twin && bodyDiffers(frame, twin, body) ? kDifferenceColours.other : kDifferenceColours.same;
        }
        const { needs, of } = kColourings[this.colouring];
        const known = !needs || this.recordings[i].has[needs];
        return (geom, body) => (known ? of : kColourings.body.of)(this.recordings[i], frame, geom, body);
    }

    update() {
        this.frames.forEach((frame, i) => {
            const stage = this.stages[i];
            if (!frame) return;
            stage.show(frame);
            stage.paint(this.colouringOf(frame, i));
            const shown = { recording: this.recordings[i], frame, bounds: this.bounds, meshes: stage.geoms };
            stage.lay([...this.shownOverlays].map(name => kOverlays[name].make(shown)).filter(Boolean));
            stage.mark(this.picked);
        });
        this.timeline.show(this.player.place);
        this.controls.show(this, this.colouring === 'difference' ? 'vermilion: differs from the other recording; grey: equal'
            : kColourings[this.colouring].meaning);
        this.inspector.show(this.picked, this.frames);
        this.announce();
        this.redraw();
    }

    // A screen reader is told of steps, not of every frame of a film.
    announce() {
        const { number, time } = this.player.frame, { playing } = this.player;
        Object.assign(this.region.dataset, { frame: number, playing, picked: this.picked ?? '' });
        this.status.textContent = playing ? 'Playing.' : `Frame ${number}, ${time.toFixed(3)} s` +
            (this.picked === null ? '.' : `; ${bodyText(this.recordings[0], this.picked)} is picked.`);
    }

    redraw() {
        if (this.waiting) return;
        this.waiting = true;
        requestAnimationFrame(() => {
            this.waiting = false;
            for (const stage of this.stages) stage.draw(this.viewpoint.camera);
            this.timeline.draw();
            this.region.dataset.drawn = this.player.frame.number;
        });
    }
}
