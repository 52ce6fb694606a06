// Prints what the Khronos validator says about GLB files, one JSON object per file and line: node validate.cjs FILE…
const fs = require("fs");
const validator = require("gltf-validator");

(async () => {
  for (const path of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(path)), { maxIssues: 100 });
    const { numErrors, numWarnings, numInfos, messages } = report.issues;
    console.log(JSON.stringify({ path, errors: numErrors, warnings: numWarnings, infos: numInfos, messages }));
  }
})();
