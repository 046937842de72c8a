// node build.mjs PROGRAM.wasm OUTPUT.html: one page with all in it, which opens from a file.
import { readFileSync, writeFileSync } from 'node:fs';

const [, , program, output] = process.argv, here = new URL('.', import.meta.url);
const text = name => readFileSync(new URL(name, here), 'utf8');
const page = text('page.html')
    .replace('@program@', () => readFileSync(program).toString('base64'))
    .replace('@script@', () => text('page.js'));
writeFileSync(output, page);
