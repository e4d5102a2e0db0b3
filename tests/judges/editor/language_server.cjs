// language_server.cjs FILE LINE:COLUMN…: opens a TOML file in the language server of the VS Code extension
// "Even Better TOML" and prints {"hovers": [text, …], "diagnostics": [message, …], "completions": [[label, …], …]}.
// Lines and columns count from 0, as the protocol does.
"use strict";
const fs = require("fs");
const path = require("path");
const { pathToFileURL, fileURLToPath } = require("url");
const { TaploLsp } = require("@taplo/lsp");

const file = path.resolve(process.argv[2]);
const places = process.argv.slice(3).map((place) => {
  const [line, character] = place.split(":").map(Number);
  return { line, character };
});
const uri = pathToFileURL(file).href;
const waiting = new Map();
const settings = { schema: { enabled: true, associations: {}, catalogs: [] } };
let diagnostics = null;
let server;

// Before it has read its settings the server looks for a catalogue of schemas in the network. There is none, as
// aboard, and it must do without.
const refuse = () => Promise.reject(new Error("no network"));
globalThis.fetch = refuse;

function receive(message) {
  if (message.method === "workspace/configuration") {
    server.send({ jsonrpc: "2.0", id: message.id, result: message.params.items.map(() => settings) });
  } else if (message.method === "textDocument/publishDiagnostics" && message.params.uri === uri) {
    diagnostics = message.params.diagnostics;
  } else if (waiting.has(message.id) && message.method === undefined) {
    waiting.get(message.id)(message.result);
    waiting.delete(message.id);
  } else if (message.id !== undefined && message.method !== undefined) {
    server.send({ jsonrpc: "2.0", id: message.id, result: null });
  }
}

let ids = 0;
function ask(method, params) {
  const id = ++ids;
  const answer = new Promise((resolve) => waiting.set(id, resolve));
  server.send({ jsonrpc: "2.0", id, method, params });
  return answer;
}

function tell(method, params) {
  server.send({ jsonrpc: "2.0", method, params });
}

async function until(condition) {
  for (let i = 0; i < 300 && !condition(); ++i) {
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

async function main() {
  const environment = {
    now: () => new Date(),
    envVar: () => undefined,
    envVars: () => [],
    stdErrAtty: () => false,
    stdin: () => Promise.resolve(new Uint8Array()),
    stdout: (bytes) => Promise.resolve(bytes.length),
    stderr: (bytes) => Promise.resolve(bytes.length),
    glob: () => [],
    readFile: (name) => fs.promises.readFile(name),
    writeFile: () => Promise.resolve(),
    urlToFilePath: (url) => (url.startsWith("file://") ? fileURLToPath(url) : ""),
    isAbsolute: (name) => path.isAbsolute(name),
    cwd: () => path.dirname(file),
    findConfigFile: () => undefined,
    fetch: { fetch: refuse, Headers: globalThis.Headers, Request: globalThis.Request, Response: globalThis.Response },
  };
  server = await TaploLsp.initialize(environment, { onMessage: receive });
  await ask("initialize", {
    processId: null,
    rootUri: pathToFileURL(path.dirname(file)).href,
    workspaceFolders: [{ uri: pathToFileURL(path.dirname(file)).href, name: "plant" }],
    initializationOptions: { configurationSection: "evenBetterToml" },
    capabilities: { workspace: { configuration: true } },
  });
  tell("initialized", {});
  tell("textDocument/didOpen", {
    textDocument: { uri, languageId: "toml", version: 1, text: fs.readFileSync(file, "utf8") },
  });
  await until(() => diagnostics !== null);
  const result = { hovers: [], diagnostics: [], completions: [] };
  for (const position of places) {
    const hover = await ask("textDocument/hover", { textDocument: { uri }, position });
    result.hovers.push(hover ? hover.contents.value : "");
    const completion = await ask("textDocument/completion", { textDocument: { uri }, position });
    const items = completion ? completion.items ?? completion : [];
    result.completions.push(items.map((item) => item.label));
  }
  result.diagnostics = (diagnostics ?? []).map((one) => `${one.range.start.line}: ${one.message}`);
  process.stdout.write(JSON.stringify(result));
  process.exit(0);
}

main().catch((error) => {
  process.stderr.write(`${error.stack}\n`);
  process.exit(1);
});
