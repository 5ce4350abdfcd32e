"use strict";
// wasi.js PROGRAM : runs a program that was built for WebAssembly with wasi-libc.
const { readFileSync } = require("node:fs");
const { WASI } = require("node:wasi");

const wasi = new WASI({ version: "preview1", args: [process.argv[2]] });
const code = new WebAssembly.Module(readFileSync(process.argv[2]));
const imports = { wasi_snapshot_preview1: wasi.wasiImport };
process.exitCode = wasi.start(new WebAssembly.Instance(code, imports));
