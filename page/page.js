// Unpacks what is in the page, and starts its parts.
async function unpack(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream()
    .pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function fill_list(select, rows) {
  for (const [value, text] of rows) {
    const option = document.createElement("option");
    option.value = value;
    option.textContent = text;
    select.append(option);
  }
}

async function start() {
  const data = JSON.parse(document.getElementById("data").textContent);
  const text = new TextDecoder().decode(await unpack(data.files));
  const files = new Map(Object.entries(JSON.parse(text)).map(([name, base64]) =>
    [name, Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))]));
  const module = await WebAssembly.compile(await unpack(data.wasm));
  const host = await new Host(files).start(module);
  const formats = [[-1, "the script's"]];
  for (let i = 0; host.exports.page_format(i); i++)
    formats.push([i, host.string(host.exports.page_format(i))]);
  fill_list(document.getElementById("format"), formats);
  fill_list(document.getElementById("scene"), [...files.keys()]
    .filter((name) => name.endsWith(".pel")).map((name) => [name, name]));
  document.getElementById("commands").textContent =
    new TextDecoder().decode(files.get("README.md"));
  const page = { files, module };
  new Sheet(page).load("first.pel");
  const ways = new Ways(host);
  matchMedia("(prefers-color-scheme: dark)")
    .addEventListener("change", () => ways.draw());
  await play(page, data.examples);
}

start().catch((e) => {
  document.getElementById("error").textContent =
    "This page needs a browser of 2023 or later: " + e.message;
});
