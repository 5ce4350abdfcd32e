// What wasi-libc asks of its host: files in memory, two streams of text, a clock.
class Host {
  // files: Map of names to Uint8Array; frame: is told what an example shows.
  constructor(files, frame) {
    this.files = files;
    this.open = new Map([[3, { folder: true }]]);
    this.text = ["", "", ""];
    this.decoders = [0, 1, 2].map(() => new TextDecoder());
    const wasi = {};
    for (const name of Object.getOwnPropertyNames(Host.prototype))
      if (name.includes("_"))
        wasi[name] = this[name].bind(this);
    this.imports = {
      wasi_snapshot_preview1: wasi,
      page: {
        frame: (at, width, height, sent) => frame({
          width, height, sent,
          bytes: this.bytes(at, width * height * 4).slice(),
        }),
      },
    };
  }
  async start(module) {
    this.exports = (await WebAssembly.instantiate(module, this.imports)).exports;
    this.exports._initialize();
    return this;
  }
  get view() { return new DataView(this.exports.memory.buffer); }
  bytes(at, size) { return new Uint8Array(this.exports.memory.buffer, at, size); }
  string(at) {
    const all = new Uint8Array(this.exports.memory.buffer, at);
    return new TextDecoder().decode(all.slice(0, all.indexOf(0)));
  }
  // The text that was printed since: 1 what is asked for, 2 messages.
  taken(stream) {
    const text = this.text[stream];
    this.text[stream] = "";
    return text;
  }

  find(at, size) {
    const name = new TextDecoder().decode(this.bytes(at, size).slice());
    return this.files.get(name.replace(/^[./]+/, ""));
  }
  // The bytes of an array of pointers and sizes, each in turn.
  *vectors(at, count) {
    for (let i = 0; i < count; i++)
      yield this.bytes(this.view.getUint32(at + 8 * i, true),
        this.view.getUint32(at + 8 * i + 4, true));
  }
  stat(at, kind, size) {
    this.bytes(at, 64).fill(0);
    this.view.setUint8(at + 16, kind);
    this.view.setBigUint64(at + 32, BigInt(size), true);
    return 0;
  }

  proc_exit(status) { throw new Error("the program ended with " + status); }
  clock_time_get(clock, precision, at) {
    this.view.setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
    return 0;
  }
  fd_prestat_get(fd, at) {
    if (fd !== 3)
      return 8;
    this.view.setUint32(at, 0, true);
    this.view.setUint32(at + 4, 1, true);
    return 0;
  }
  fd_prestat_dir_name(fd, at) {
    this.bytes(at, 1)[0] = 47;
    return 0;
  }
  fd_fdstat_get(fd, at) {
    this.bytes(at, 24).fill(0);
    this.view.setUint8(at, fd < 3 ? 2 : this.open.get(fd).folder ? 3 : 4);
    this.bytes(at + 8, 16).fill(255);
    return 0;
  }
  fd_fdstat_set_flags() { return 0; }
  path_filestat_get(fd, flags, path, size, at) {
    const file = this.find(path, size);
    return file ? this.stat(at, 4, file.length) : 44;
  }
  path_open(fd, flags, path, size, oflags, rights, inherited, fdflags, at) {
    const bytes = this.find(path, size);
    if (!bytes)
      return 44;
    let next = 4;
    while (this.open.has(next))
      next++;
    this.open.set(next, { bytes, at: 0 });
    this.view.setUint32(at, next, true);
    return 0;
  }
  fd_close(fd) {
    this.open.delete(fd);
    return 0;
  }
  fd_seek(fd, offset, whence, at) {
    const file = this.open.get(fd);
    if (!file)
      return 70;
    file.at = Number(offset) + [0, file.at, file.bytes.length][whence];
    this.view.setBigUint64(at, BigInt(file.at), true);
    return 0;
  }
  fd_read(fd, vectors, count, at) {
    const file = this.open.get(fd);
    let done = 0;
    for (const to of file ? this.vectors(vectors, count) : []) {
      const part = file.bytes.subarray(file.at, file.at + to.length);
      to.set(part);
      file.at += part.length;
      done += part.length;
    }
    this.view.setUint32(at, done, true);
    return 0;
  }
  fd_write(fd, vectors, count, at) {
    let done = 0;
    for (const from of this.vectors(vectors, count)) {
      this.text[fd] += this.decoders[fd].decode(from.slice(), { stream: true });
      done += from.length;
    }
    this.view.setUint32(at, done, true);
    return 0;
  }
  // All is ready at once.
  poll_oneoff(from, to, count, at) {
    for (let i = 0; i < count; i++) {
      this.bytes(to + 32 * i, 32).fill(0);
      this.bytes(to + 32 * i, 8).set(this.bytes(from + 48 * i, 8));
      this.view.setUint8(to + 32 * i + 10, this.view.getUint8(from + 48 * i + 8));
    }
    this.view.setUint32(at, count, true);
    return 0;
  }
}
