// Which frame is shown, and whether time runs. Frames are shown as they were recorded, never in between.

export class Player {
    constructor(frames, onChange) {
        this.frames = frames;
        this.onChange = onChange;
        this.place = 0;
        this.speed = 1;  // simulated seconds in a second
        this.playing = false;
    }

    get frame() {
        return this.frames[this.place];
    }

    go(place) {
        const within = Math.min(Math.max(place, 0), this.frames.length - 1);
        if (within === this.place) return;
        this.place = within;
        this.time = this.frame.time;
        this.onChange();
    }

    // Goes to the last frame that is not after this number of frames.
    goToNumber(number) {
        this.go(this.frames.filter(frame => frame.number <= number).length - 1);
    }

    toggle() {
        if (this.playing) this.pause();
        else this.play();
    }

    play() {
        if (this.place === this.frames.length - 1) this.place = 0;
        this.playing = true;
        this.time = this.frame.time;
        this.last = performance.now();
        requestAnimationFrame(now => this.run(now));
        this.onChange();
    }

    pause() {
        this.playing = false;
        this.onChange();
    }

    run(now) {
        if (!this.playing) return;
        this.time += this.speed * Math.max(0, now - this.last) / 1000;
        this.last = now;
        let place = this.place;
        while (place + 1 < this.frames.length && this.frames[place + 1].time <= this.time) ++place;
        if (place !== this.place) {
            this.place = place;
            this.onChange();
        }
        if (place === this.frames.length - 1) this.pause();
        else requestAnimationFrame(next => this.run(next));
    }
}
