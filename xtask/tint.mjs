// Tint's verdict on every *.wgsl of a folder, by way of Dawn's null backend, which needs no driver.
//
// node tint.mjs HOME FOLDER: HOME holds node_modules/webgpu. One line a message, path:line:column; exit code 1 when a
// file is refused or none is there.
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [home, folder] = process.argv.slice(2);
const { create } = await import(pathToFileURL(resolve(home, 'node_modules/webgpu/index.js')));
// Dawn's instance must outlive its devices, and the garbage collector does not know: a global keeps it.
globalThis.gpu = create(['backend=null']);
globalThis.adapter = await gpu.requestAdapter();
const device = await adapter.requestDevice();
// Refusals are read from getCompilationInfo; without a listener Dawn would print each of them a second time.
device.addEventListener('uncapturederror', (event) => event.preventDefault());

const messages = async (label, code) => (await device.createShaderModule({ label, code }).getCompilationInfo()).messages;
const isError = ({ type }) => type === 'error';

// A validator that accepts everything must not pass for one.
if (!(await messages('planted', 'fn planted() -> f32 { return 1u; }')).some(isError)) {
  console.error('tint: a planted type error was accepted');
  process.exit(1);
}

const files = readdirSync(folder).filter((name) => name.endsWith('.wgsl')).sort();
let refused = 0;
for (const name of files) {
  const path = join(folder, name);
  const found = await messages(name, readFileSync(path, 'utf8'));
  for (const { type, lineNum, linePos, message } of found) {
    console.error(`${path}:${lineNum}:${linePos}: ${type}: ${message}`);
  }
  if (found.some(isError)) refused += 1;
}
console.log(`tint: ${files.length - refused} of ${files.length} modules valid`);
device.destroy();
process.exit(refused > 0 || files.length === 0 ? 1 : 0);
