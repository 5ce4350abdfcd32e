"use strict";
// build.js WASM "EXAMPLES" : the page as one HTML file, to standard output. Code
// and scenes are packed by gzip, which the browser undoes.
const { readFileSync, readdirSync } = require("node:fs");
const { gzipSync } = require("node:zlib");

const read = (name) => readFileSync(name, "utf8");
const pack = (bytes) => gzipSync(bytes, { level: 9 }).toString("base64");

const files = { "first.pel": readFileSync("page/first.pel").toString("base64") };
for (const name of readdirSync("sim/scenes").sort())
  if (/\.(pel|ppm|bdf|md)$/.test(name))
    files[name] = readFileSync("sim/scenes/" + name).toString("base64");
const data = {
  wasm: pack(readFileSync(process.argv[2])),
  files: pack(JSON.stringify(files)),
  examples: process.argv[3].split(" "),
};
process.stdout.write(read("page/page.html")
  .replace("@CSS@", () => read("page/page.css").trim())
  .replace("@DATA@", () => JSON.stringify(data))
  .replace("@JS@", () => '"use strict";\n' +
    ["wasi", "worker", "script", "players", "methods", "page"]
      .map((name) => read("page/" + name + ".js")).join("\n").trim()));
