// node compare.cjs CORNER_TANGENTS FOLDER MODEL...: see run.
const fs = require('fs'), path = require('path'), { execFileSync } = require('child_process');
const { generateTangents } = require('mikktspace');
const [tool, folder, ...models] = process.argv.slice(2);

function load(file) {
  const bytes = fs.readFileSync(file);
  let gltf, chunk;
  if (bytes.readUInt32LE(0) === 0x46546c67) {
    const length = bytes.readUInt32LE(12);
    gltf = JSON.parse(bytes.subarray(20, 20 + length));
    chunk = bytes.subarray(28 + length);
  } else gltf = JSON.parse(bytes);
  const buffers = gltf.buffers.map((b) => !b.uri ? chunk : b.uri.startsWith('data:')
    ? Buffer.from(b.uri.split(',')[1], 'base64')
    : fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(b.uri))));
  return { gltf, buffers };
}

// Rows of numbers; normalised integers become floats.
function read({ gltf, buffers }, index) {
  const a = gltf.accessors[index], n = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[a.type];
  const [size, get, scale] = { 5126: [4, 'readFloatLE', 1], 5125: [4, 'readUInt32LE', 1], 5123: [2, 'readUInt16LE', 65535],
    5121: [1, 'readUInt8', 255] }[a.componentType];
  const view = gltf.bufferViews[a.bufferView], stride = view.byteStride || n * size;
  const start = (view.byteOffset || 0) + (a.byteOffset || 0);
  return Array.from({ length: a.count }, (_, i) => Array.from({ length: n }, (_, k) =>
    buffers[view.buffer][get](start + i * stride + k * size) / (a.normalized ? scale : 1)));
}

// Corners that agree to 1e-4 with equal w, whose w agrees, and those where MikkTSpace knows no tangent (triangles without
// area in texture space, not connected to any with area): it then gives +X whatever the normal, we a perpendicular.
function agreement(ours, theirs, sign) {
  const result = { count: ours.length / 4, same: 0, sameW: 0, unknown: 0, worst: 0 };
  for (let i = 0; i < ours.length; i += 4) {
    const d = Math.max(...[0, 1, 2].map((k) => Math.abs(ours[i + k] - theirs[i + k])));
    const w = ours[i + 3] === sign * theirs[i + 3];
    result.sameW += w;
    if (w && d <= 1e-4) result.same++;
    else if (sign < 0 && theirs[i] === 1 && theirs[i + 1] === 0 && theirs[i + 2] === 0 && w) result.unknown++;
    else result.worst = Math.max(result.worst, d);
  }
  return result;
}
const percent = (part, whole) => `${(whole ? (100 * part) / whole : 100).toFixed(3)} %`;

let failed = false;
for (const file of models) {
  const model = load(file), total = { count: 0, same: 0, unknown: 0 };
  for (const mesh of model.gltf.meshes) for (const p of mesh.primitives) {
    const at = p.attributes;
    if ((p.mode ?? 4) !== 4 || at.NORMAL === undefined || at.TEXCOORD_0 === undefined || p.extensions?.KHR_draco_mesh_compression) continue;
    const [x, n, uv] = [at.POSITION, at.NORMAL, at.TEXCOORD_0].map((i) => read(model, i));
    const corners = p.indices === undefined ? x.map((_, i) => i) : read(model, p.indices).map((r) => r[0]);
    const gather = (rows) => new Float32Array(corners.flatMap((c) => rows[c]));
    const input = path.join(folder, 'in'), output = path.join(folder, 'out');
    fs.writeFileSync(input, Buffer.from(new Float32Array(corners.flatMap((c) => [...x[c], ...n[c], ...uv[c]])).buffer));
    const [ms, vertices] = execFileSync(tool, [input, output]).toString().trim().split(' ');
    const ours = new Float32Array(new Uint8Array(fs.readFileSync(output)).buffer);
    const mikk = agreement(ours, generateTangents(gather(x), gather(n), gather(uv)), -1);
    for (const key in total) total[key] += mikk[key];
    let line = `  ${(mesh.name || '-').slice(0, 24).padEnd(24)} ${x.length} -> ${vertices} vertices, ${ms} ms: ` +
      `${percent(mikk.same, mikk.count - mikk.unknown)} same, others up to ${mikk.worst.toExponential(1)}`;
    if (at.TANGENT !== undefined) {
      const given = agreement(ours, gather(read(model, at.TANGENT)), 1);
      line += `; the file's own: ${percent(given.same, given.count)} same, ${percent(given.sameW, given.count)} of w`;
    }
    console.log(line);
  }
  if (!total.count) continue;
  const known = total.count - total.unknown;
  failed ||= total.same < 0.999 * known;
  console.log(`${path.basename(file)}: ${percent(total.same, known)} of ${known} corners; ${total.unknown} have no tangent`);
}
process.exit(failed ? 1 : 0);
