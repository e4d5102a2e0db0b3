// ajv_judge.cjs SCHEMA: reads documents from standard input, {"name": document, …}, and prints
// {"name": ["/path message", …], …}. A schema that ajv's strict mode objects to is an error.
"use strict";
const fs = require("fs");
const Ajv = require("ajv");

const complain = (...words) => {
  throw new Error(words.join(" "));
};
const ajv = new Ajv({
  allErrors: true,
  strict: true,
  strictRequired: false, // a condition may ask for a key that is described elsewhere
  allowUnionTypes: true,
  logger: { log: complain, warn: complain, error: complain },
});
const validate = ajv.compile(JSON.parse(fs.readFileSync(process.argv[2], "utf8")));
const documents = JSON.parse(fs.readFileSync(0, "utf8"));
const verdicts = {};
for (const [name, document] of Object.entries(documents)) {
  verdicts[name] = validate(document) ? [] : validate.errors.map((e) => `${e.instancePath} ${e.message}`);
}
process.stdout.write(JSON.stringify(verdicts));
