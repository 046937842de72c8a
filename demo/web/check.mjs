// node check.mjs weft.html PICTURE.png: the page in a browser without a window, by a visitor's mouse. The flag blows towards it, a ball goes
// through, each slider is pulled to both ends; nothing crosses or breaks, and a picture is taken.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const [, , page, picture] = process.argv, folder = mkdtempSync(join(tmpdir(), 'weft-page-'));
const browser = spawn('chromium', ['--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars',
    '--window-size=1200,750', '--user-data-dir=' + join(folder, 'profile'), '--remote-debugging-pipe'],
{ stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });

// Chrome's DevTools protocol, by pipes: JSON with a zero behind each message.
const waiting = new Map();
let number = 0, session, text = '';
browser.stdio[4].on('data', bytes => {
    const messages = (text + bytes).split('\0');
    text = messages.pop();
    for (const message of messages.map(JSON.parse)) {
        const { done, fails } = waiting.get(message.id) ?? {};
        if (message.error) fails?.(new Error(message.error.message));
        else done?.(message.result);
    }
});
const ask = (method, params = {}) => new Promise((done, fails) => {
    waiting.set(++number, { done, fails });
    browser.stdio[3].write(JSON.stringify({ id: number, method, params, sessionId: session }) + '\0');
});
const evaluate = async expression => (await ask('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true })).result.value;

const state = async () => JSON.parse(await evaluate('JSON.stringify({ ...document.body?.dataset })') ?? '{}');
async function steps(count) {
    const until = Number((await state()).steps ?? 0) + count, limit = Date.now() + 400000;
    for (;;) {
        const now = await state();
        if (now.error) throw new Error('the page says: ' + now.error);
        if (Number(now.steps ?? 0) >= until) return now;
        if (Date.now() > limit) throw new Error('too few steps: ' + JSON.stringify(now));
        await new Promise(done => setTimeout(done, 100));
    }
}
const mouse = (type, x, y, button = type === 'mouseMoved' ? 'none' : 'left') =>
    ask('Input.dispatchMouseEvent', { type, x, y, button, buttons: type !== 'mouseReleased' && button === 'left' ? 1 : 0, clickCount: 1 });
const tip = async () => (await state()).tip.split(' ').map(Number);

// Drags a slider to its left or its right end, as a hand does.
async function slide(name, toRight) {
    const box = JSON.parse(await evaluate(`JSON.stringify(document.getElementById('${name}').getBoundingClientRect())`));
    const y = box.y + box.height / 2;
    await mouse('mousePressed', box.x + box.width / 2, y);
    await mouse('mouseMoved', toRight ? box.right + 30 : box.x - 30, y, 'left');
    await mouse('mouseReleased', toRight ? box.right + 30 : box.x - 30, y);
    const [value, end] = JSON.parse(await evaluate(
        `(at => JSON.stringify([at.value, at.${toRight ? 'max' : 'min'}]))(document.getElementById('${name}'))`));
    if (value !== end) throw new Error(`the slider ${name} stands at ${value}, not at its end ${end}`);
}

async function slideAll() {
    const failures = [];
    for (const name of ['wind', 'gust', 'size']) {
        for (const toRight of [false, true]) {
            await slide(name, toRight);
            const now = await steps(40), place = await tip();
            const where = `${name} at its ${toRight ? 'right' : 'left'} end`;
            console.log(where + ':', await evaluate("document.getElementById('report').textContent"), '; its free corner:', place);
            if (!place.every(x => Math.abs(x) < 3)) failures.push(where + ': the flag is at ' + place);
            if (now.crossings !== '0') failures.push(where + ': ' + now.crossings + ' edges go through triangles');
        }
    }
    return failures;
}

async function visit() {
    const { targetId } = await ask('Target.createTarget', { url: 'file://' + resolve(page) });
    session = (await ask('Target.attachToTarget', { targetId, flatten: true })).sessionId;
    await steps(30);
    await mouse('mouseMoved', 1150, 400);
    await steps(120);
    const right = await tip();
    await mouse('mouseMoved', 30, 600);
    await steps(120);
    const left = await tip();
    await mouse('mouseMoved', 1100, 360);
    await steps(90);
    await mouse('mouseMoved', 640, 390);
    await mouse('mousePressed', 640, 390);
    const last = await steps(45);
    writeFileSync(picture, Buffer.from((await ask('Page.captureScreenshot')).data, 'base64'));
    console.log(await evaluate("document.getElementById('report').textContent"), '; to the right:', right, '; to the left:', left);
    await mouse('mouseReleased', 640, 390);
    const failures = await slideAll();
    return failures.concat([
        [!(right[0] > left[0] + 0.3), 'the flag does not blow towards the mouse'],
        [last.crossings !== '0', last.crossings + ' edges go through triangles'],
        [last.glError !== '0', 'WebGL has the error ' + last.glError],
    ].filter(([failed]) => failed).map(([, why]) => why));
}

let failures;
try {
    failures = await visit();
} catch (error) {
    failures = [error.message];
}
for (const why of failures) console.error(why);
browser.kill();
await new Promise(done => browser.on('exit', done));
rmSync(folder, { recursive: true, force: true });
process.exit(failures.length > 0 ? 1 : 0);
