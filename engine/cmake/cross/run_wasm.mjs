// node run_wasm.mjs PROGRAM.wasm [arguments] runs the program with access to this machine's files.
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

const [, , program, ...rest] = process.argv;
const { WEFT_DATA, ...env } = process.env; // real garments are OBJ files, which the library does not read there
const wasi = new WASI({ version: 'preview1', args: [program, ...rest], env, preopens: { '/': '/' } });
const module = await WebAssembly.compile(await readFile(program));
process.exit(wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject())));
