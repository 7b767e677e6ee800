/**
 * Signatures of the vendors' libraries, as far as the adapters use them: written from their documentation, compiled
 * against, never shipped. At run time the installed library takes their place.
 */
package signatures;
